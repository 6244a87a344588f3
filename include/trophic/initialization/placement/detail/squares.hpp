// SPDX-License-Identifier: MIT
// Finds nearby robots, for placements that keep robots apart.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <trophic/habitat/ground_pose.hpp>
#include <vector>

namespace trophic::initialization::placement::detail {

/// The robots in each square of a grid: every robot closer than two radii to a pose is in its square or in a neighbouring one.
class Squares {
 public:
  Squares(double reach_m, double radius_m, std::size_t robots)
      : reach_m_{reach_m},
        // A margin for rounding, and no more squares than robots.
        square_m_{std::max({2.001 * radius_m, 2.0 * reach_m / std::ceil(std::sqrt(static_cast<double>(robots))), 1e-6})},
        side_{place_of(reach_m) + 1},
        standing_(side_ * side_) {}

  void add(const GroundPose& pose) { standing_[place_of(pose.y_m) * side_ + place_of(pose.x_m)].push_back(pose); }

  /// Returns whether `holds(other)` is true for every robot near a pose.
  template <class Holds>
  [[nodiscard]] bool all_near(const GroundPose& pose, const Holds& holds) const {
    const std::size_t column = place_of(pose.x_m);
    const std::size_t row = place_of(pose.y_m);
    for (std::size_t y = row - std::min<std::size_t>(row, 1); y <= std::min(row + 1, side_ - 1); ++y) {
      for (std::size_t x = column - std::min<std::size_t>(column, 1); x <= std::min(column + 1, side_ - 1); ++x) {
        if (!std::ranges::all_of(standing_[y * side_ + x], holds)) return false;
      }
    }
    return true;
  }

 private:
  [[nodiscard]] std::size_t place_of(double offset_m) const {
    return static_cast<std::size_t>((offset_m + reach_m_) / square_m_);
  }

  double reach_m_;
  double square_m_;
  std::size_t side_;
  std::vector<std::vector<GroundPose>> standing_;
};

}  // namespace trophic::initialization::placement::detail
