// SPDX-License-Identifier: MIT
// Student's t distribution.
#pragma once

namespace trophic::analysis {

/// The value that a t of `freedom` > 0 degrees of freedom stays below with this probability, 0 < probability < 1.
[[nodiscard]] double student_t_quantile(double probability, double freedom);

/// The probability that |t| is `t` >= 0 or more.
[[nodiscard]] double student_t_two_sided(double t, double freedom);

}  // namespace trophic::analysis
