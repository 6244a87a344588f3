// SPDX-License-Identifier: MIT
// Finds robots that may soon touch each other: connected sets of overlapping discs.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <trophic/population/spatial_grid.hpp>
#include <vector>

namespace trophic::backend {

/// A disc on the floor that a robot cannot leave within the coming steps. A negative radius means that the robot is absent.
struct Disc {
  double x_m = 0.0;
  double y_m = 0.0;
  double radius_m = 0.0;
  [[nodiscard]] bool is_absent() const { return radius_m < 0.0; }
};

/// Whether two discs overlap or touch.
[[nodiscard]] inline bool touch(const Disc& a, const Disc& b) {
  const double reach_m = a.radius_m + b.radius_m;
  const double dx = a.x_m - b.x_m;
  const double dy = a.y_m - b.y_m;
  return dx * dx + dy * dy <= reach_m * reach_m;
}

/// Splits the discs 0 .. n-1 into the connected sets of "overlap or touch". Each set is ascending; the sets are ordered by
/// size, largest first, then by their first member. Absent robots are in no set; neither are single robots if `lone` takes them.
/// Grid and union-find: linear in n for scattered discs.
[[nodiscard]] inline std::vector<std::vector<std::size_t>> connected_sets(std::span<const Disc> discs,
                                                                          std::vector<std::size_t>* lone = nullptr) {
  std::vector<std::size_t> root(discs.size());
  std::iota(root.begin(), root.end(), std::size_t{0});
  const auto find = [&](std::size_t i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };

  std::vector<GroundPose> centres;
  centres.reserve(discs.size());
  double largest_m = 0.0;
  for (const Disc& disc : discs) {
    centres.push_back({disc.x_m, disc.y_m});
    largest_m = std::max(largest_m, disc.radius_m);
  }
  const SpatialGrid grid{centres};
  for (std::size_t i = 0; i < discs.size(); ++i) {
    const Disc& a = discs[i];
    if (a.is_absent()) continue;
    grid.for_each_near(a.x_m, a.y_m, a.radius_m + largest_m, [&](std::size_t j) {
      if (j <= i || discs[j].is_absent() || !touch(a, discs[j])) return;
      const auto [low, high] = std::minmax({find(i), find(j)});
      root[high] = low;
    });
  }

  std::vector<std::vector<std::size_t>> sets;
  std::vector<std::size_t> set_of_root(discs.size(), discs.size());
  for (std::size_t i = 0; i < discs.size(); ++i) {
    const std::size_t own_root = find(i);
    if (own_root == i) continue;
    if (set_of_root[own_root] == discs.size()) {
      set_of_root[own_root] = sets.size();
      sets.push_back({own_root});
    }
    sets[set_of_root[own_root]].push_back(i);
  }
  std::ranges::sort(sets, [](const auto& a, const auto& b) { return a.size() != b.size() ? a.size() > b.size() : a[0] < b[0]; });
  for (std::size_t i = 0; i < discs.size(); ++i) {
    if (root[i] != i || set_of_root[i] != discs.size() || discs[i].is_absent()) continue;
    lone != nullptr ? lone->push_back(i) : sets.push_back({i});
  }
  return sets;
}

}  // namespace trophic::backend
