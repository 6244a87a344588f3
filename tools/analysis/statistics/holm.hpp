// SPDX-License-Identifier: MIT
// Many comparisons at once: how likely any of them is wrong.
#pragma once

#include <span>
#include <vector>

namespace trophic::analysis {

/// Holm's step-down correction [holm1979]. An adjusted value <= 0.05 is found in at most 5 % of analyses in which nothing
/// differs, however the comparisons depend on each other. The k-th smallest of m values becomes the largest (m - j + 1) p_j of j
/// = 1,
/// ..., k.
[[nodiscard]] std::vector<double> holm(std::span<const double> p_values);

}  // namespace trophic::analysis
