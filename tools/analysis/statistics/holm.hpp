// SPDX-License-Identifier: MIT
// Many comparisons at once: how likely any of them is wrong.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

namespace trophic::analysis {

/// Holm's step-down correction [holm1979]. An adjusted value <= 0.05 is found in at most 5 % of analyses in which nothing
/// differs, however the comparisons hang together. The k-th smallest of m values becomes the largest (m - j + 1) p_j of j = 1,
/// ..., k.
[[nodiscard]] inline std::vector<double> holm(std::span<const double> p_values) {
  std::vector<std::size_t> order(p_values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return p_values[i]; });
  std::vector<double> adjusted(p_values.size());
  double largest = 0.0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    largest = std::max(largest, static_cast<double>(order.size() - k) * p_values[order[k]]);
    adjusted[order[k]] = std::min(1.0, largest);
  }
  return adjusted;
}

}  // namespace trophic::analysis
