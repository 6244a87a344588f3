// SPDX-License-Identifier: MIT
// Definitions of student_t.hpp.
#include <tools/analysis/statistics/student_t.hpp>

#include <boost/math/distributions/students_t.hpp>

namespace trophic::analysis {

double student_t_quantile(double probability, double freedom) {
  return boost::math::quantile(boost::math::students_t{freedom}, probability);
}

double student_t_two_sided(double t, double freedom) {
  return 2.0 * boost::math::cdf(boost::math::complement(boost::math::students_t{freedom}, t));
}

}  // namespace trophic::analysis
