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
#include <stdexcept>
#include <tools/analysis/statistics/student_t.hpp>
#include <trophic/params/params.hpp>

namespace trophic::analysis {

double power_of_t(double errors, double freedom, double level) {
  // A sweep asks a million times: doubles are six times as fast as the long doubles that are the default.
  using Fast = boost::math::policies::policy<boost::math::policies::promote_double<false>>;
  const boost::math::students_t_distribution<double, Fast> still{freedom};
  const double critical = boost::math::quantile(boost::math::complement(still, level / 2.0));
  // With so many standard errors the normal part of the noncentral t is negligible next to the spread of the estimated error.
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

std::optional<Scatter> scatter_of(std::span<const double> values) {
  if (values.size() < 2) return std::nullopt;
  return Scatter{std::pow(*deviation_of(values), 2.0), 1.0};
}

std::optional<Scatter> scatter_of(std::span<const double> a, std::span<const double> b) {
  return scatter_of({a, b});
}

std::optional<Scatter> scatter_of(std::initializer_list<std::span<const double>> sets) {
  double sum = 0.0;
  double squares = 0.0;
  for (const std::span<const double> set : sets) {
    const auto one = scatter_of(set);
    if (!one) return std::nullopt;
    sum += one->variance;
    squares += one->variance * one->variance;
  }
  return Scatter{sum, squares > 0.0 ? sum * sum / squares : 1.0};
}

double detectable_difference(const Contrast& of, double level, double power) {
  return of.error == 0.0 ? 0.0 : of.error * errors_for_power(of.freedom, level, power);
}

std::optional<std::size_t> runs_for_power(double difference, const Scatter& scatter, double level, double power) {
  const auto check = [](const char* name, double value) {
    if (value > 0.0 && value < 1.0) return;
    throw std::invalid_argument{std::string{name} + " = " + number_text(value) + ": must be > 0 and < 1"};
  };
  check("level", level);
  check("power", power);
  if (difference == 0.0) return std::nullopt;
  if (is_rounding(std::sqrt(scatter.variance), difference)) return min_runs_for_test;
  const double spreads = std::abs(difference) / std::sqrt(scatter.variance);
  const auto suffices = [&](std::size_t runs) {
    const auto count = static_cast<double>(runs);
    return power_of_t(spreads * std::sqrt(count), scatter.freedom * (count - 1.0), level) >= power;
  };
  // The normal distribution asks for fewer runs than t does: from there upwards in growing steps, then back by halving.
  constexpr double as_good_as_normal = 1e9;
  const double wanted = student_t_quantile(1.0 - level / 2.0, as_good_as_normal) + student_t_quantile(power, as_good_as_normal);
  const double fewest = std::pow(std::max(wanted, 0.0) / spreads, 2.0);
  if (fewest > static_cast<double>(most_runs)) return std::nullopt;
  std::size_t enough = std::max(min_runs_for_test, static_cast<std::size_t>(fewest));
  std::size_t few = enough - 1;
  for (std::size_t step = 1; !suffices(enough); step *= 2) {
    few = enough;
    enough += step;
    if (enough > most_runs) return std::nullopt;
  }
  while (enough - few > 1) {
    const std::size_t middle = few + (enough - few) / 2;
    (suffices(middle) ? enough : few) = middle;
  }
  return enough;
}

}  // namespace trophic::analysis
