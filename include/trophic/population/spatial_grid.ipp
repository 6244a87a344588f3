// SPDX-License-Identifier: MIT
// Definitions of spatial_grid.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <trophic/population/spatial_grid.hpp>

namespace trophic {

TROPHIC_INLINE SpatialGrid::SpatialGrid(std::span<const GroundPose> poses) {
  double high_x_m = -std::numeric_limits<double>::infinity();
  double high_y_m = high_x_m;
  for (const GroundPose& pose : poses) {
    low_x_m_ = std::min(low_x_m_, pose.x_m);
    low_y_m_ = std::min(low_y_m_, pose.y_m);
    high_x_m = std::max(high_x_m, pose.x_m);
    high_y_m = std::max(high_y_m, pose.y_m);
  }
  const double side_m = std::max({high_x_m - low_x_m_, high_y_m - low_y_m_, 1e-6});
  cells_ = static_cast<std::ptrdiff_t>(std::ceil(std::sqrt(static_cast<double>(poses.size()) / 2.0)));
  cell_m_ = side_m / static_cast<double>(cells_);
  rounding_m_ = 1e-9 * (std::abs(low_x_m_) + std::abs(low_y_m_) + side_m);
  starts_.assign(static_cast<std::size_t>(cells_ * cells_) + 1, 0);
  for (const GroundPose& pose : poses) ++starts_[index(column(pose), row(pose)) + 1];
  for (std::size_t cell = 1; cell < starts_.size(); ++cell) starts_[cell] += starts_[cell - 1];
  bodies_.resize(poses.size());
  std::vector<std::size_t> next(starts_.begin(), starts_.end() - 1);
  for (BodyIndex body = 0; body < poses.size(); ++body) {
    bodies_[next[index(column(poses[body]), row(poses[body]))]++] = body;
  }
}

}  // namespace trophic
