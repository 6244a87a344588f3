// SPDX-License-Identifier: MIT
// Definitions of power.hpp.
#include <tools/analysis/statistics/power.hpp>

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/non_central_t.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/policies/policy.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <tools/analysis/statistics/student_t.hpp>

namespace trophic::analysis {

double power_of_t(double errors, double freedom, double level) {
  // A sweep asks a million times: doubles are six times as fast as the long doubles that are the default.
  using Fast = boost::math::policies::policy<boost::math::policies::promote_double<false>>;
  const boost::math::students_t_distribution<double, Fast> still{freedom};
  const double critical = boost::math::quantile(boost::math::complement(still, level / 2.0));
  // Of so many errors the noncentral t's own noise is nothing beside that of the error that they are measured by.
  constexpr double far = 200.0;
  if (std::abs(errors) > far) {
    const boost::math::chi_squared_distribution<double, Fast> error{freedom};
    return boost::math::cdf(error, freedom * std::pow(errors / critical, 2.0));
  }
  const boost::math::non_central_t_distribution<double, Fast> moved{freedom, std::abs(errors)};
  return boost::math::cdf(boost::math::complement(moved, critical)) + boost::math::cdf(moved, -critical);
}

double errors_for_power(double freedom, double level, double power) {
  const auto missing = [&](double errors) { return power_of_t(errors, freedom, level) - power; };
  const double guess = student_t_quantile(1.0 - level / 2.0, freedom) + std::max(0.0, student_t_quantile(power, freedom));
  double low = 0.0;
  double high = guess;
  while (missing(high) < 0.0) {
    low = high;
    high *= 2.0;
  }
  if (missing(low) >= 0.0) return low;
  std::uintmax_t steps = 200;
  const auto near = boost::math::tools::toms748_solve(missing, low, high, boost::math::tools::eps_tolerance<double>{24}, steps);
  return near.second;
}

}  // namespace trophic::analysis
