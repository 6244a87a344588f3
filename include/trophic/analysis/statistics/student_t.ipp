// SPDX-License-Identifier: MIT
// Definitions of student_t.hpp.
#pragma once

#include <boost/math/distributions/students_t.hpp>
#include <trophic/analysis/statistics/student_t.hpp>

namespace trophic::analysis {

TROPHIC_INLINE double student_t_quantile(double probability, double freedom) {
  return boost::math::quantile(boost::math::students_t{freedom}, probability);
}

TROPHIC_INLINE double student_t_two_sided(double t, double freedom) {
  return 2.0 * boost::math::cdf(boost::math::complement(boost::math::students_t{freedom}, t));
}

}  // namespace trophic::analysis
