// SPDX-License-Identifier: MIT
// Which robots may touch each other soon: connected sets of overlapping discs.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

namespace trophic::backend {

/// A disc on the floor that a robot cannot leave within the coming steps.
struct Disc {
  double x_m = 0.0;
  double y_m = 0.0;
  double radius_m = 0.0;
};

/// Splits the discs 0 .. n-1 into the connected sets of "overlap or touch". Each set is ascending; the sets are ordered by size,
/// largest first, then by their first member. Sweep over x with union-find: n log n for discs that are spread out.
[[nodiscard]] inline std::vector<std::vector<std::size_t>> connected_sets(std::span<const Disc> discs) {
  std::vector<std::size_t> root(discs.size());
  std::iota(root.begin(), root.end(), std::size_t{0});
  const auto find = [&](std::size_t i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };

  std::vector<std::size_t> by_left_edge = root;
  const auto left_m = [&](std::size_t i) { return discs[i].x_m - discs[i].radius_m; };
  std::ranges::sort(by_left_edge,
                    [&](std::size_t a, std::size_t b) { return left_m(a) != left_m(b) ? left_m(a) < left_m(b) : a < b; });
  for (std::size_t i = 0; i < by_left_edge.size(); ++i) {
    const Disc& a = discs[by_left_edge[i]];
    for (std::size_t j = i + 1; j < by_left_edge.size() && left_m(by_left_edge[j]) <= a.x_m + a.radius_m; ++j) {
      const Disc& b = discs[by_left_edge[j]];
      const double reach_m = a.radius_m + b.radius_m;
      const double dx = a.x_m - b.x_m;
      const double dy = a.y_m - b.y_m;
      if (dx * dx + dy * dy > reach_m * reach_m) continue;
      const auto [low, high] = std::minmax({find(by_left_edge[i]), find(by_left_edge[j])});
      root[high] = low;
    }
  }

  std::vector<std::vector<std::size_t>> sets;
  std::vector<std::size_t> set_of_root(discs.size());
  for (std::size_t i = 0; i < discs.size(); ++i) {
    const std::size_t own_root = find(i);
    if (own_root == i) {
      set_of_root[i] = sets.size();
      sets.emplace_back();
    }
    sets[set_of_root[own_root]].push_back(i);
  }
  std::ranges::stable_sort(sets, std::ranges::greater{}, &std::vector<std::size_t>::size);
  return sets;
}

}  // namespace trophic::backend
