// SPDX-License-Identifier: MIT
// Finds near robots without looking at all of them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <trophic/population/individual.hpp>
#include <trophic/support/units.hpp>
#include <vector>

namespace trophic {

/// Robots sorted into the square cells of a grid over the box that holds them all, about two to a cell. Searches give exactly
/// what looking at every robot gives, ties included. Holds indices only: the poses that it was built from must be given again.
class SpatialGrid {
 public:
  SpatialGrid() = default;
  explicit SpatialGrid(std::span<const GroundPose> poses) {
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
    starts_.assign(static_cast<std::size_t>(cells_ * cells_) + 1, 0);
    for (const GroundPose& pose : poses) ++starts_[index(column(pose), row(pose)) + 1];
    for (std::size_t cell = 1; cell < starts_.size(); ++cell) starts_[cell] += starts_[cell - 1];
    bodies_.resize(poses.size());
    std::vector<std::size_t> next(starts_.begin(), starts_.end() - 1);
    for (BodyIndex body = 0; body < poses.size(); ++body) {
      bodies_[next[index(column(poses[body]), row(poses[body]))]++] = body;
    }
  }

  /// The body closest to `self` for which `accepts(body)` holds, itself excluded; on equal distance the lower index.
  template <class Accepts>
  [[nodiscard]] std::optional<BodyIndex> closest(BodyIndex self, std::span<const GroundPose> poses, Accepts&& accepts) const {
    std::optional<BodyIndex> best;
    double best_m = std::numeric_limits<double>::infinity();
    const std::ptrdiff_t home_column = column(poses[self]);
    const std::ptrdiff_t home_row = row(poses[self]);
    for (std::ptrdiff_t ring = 0; ring < cells_; ++ring) {
      // Whoever stands beyond the rings searched so far is at least ring - 1 cells away.
      if (best_m < (static_cast<double>(ring) - 1.0) * cell_m_) break;
      for_each_cell_of_ring(home_column, home_row, ring, [&](std::size_t cell) {
        for (std::size_t i = starts_[cell]; i < starts_[cell + 1]; ++i) {
          const BodyIndex body = bodies_[i];
          if (body == self || !accepts(body)) continue;
          const double d = distance_m(poses[self], poses[body]);
          if (d < best_m || (d == best_m && best && body < *best)) {
            best_m = d;
            best = body;
          }
        }
      });
    }
    return best;
  }

  /// Calls `visit(body)` once for every body within `radius_m` of a point, and for some that are farther away.
  template <class Visit>
  void for_each_near(double x_m, double y_m, double radius_m, Visit&& visit) const {
    const std::ptrdiff_t last_column = cell_of(x_m + radius_m - low_x_m_);
    const std::ptrdiff_t last_row = cell_of(y_m + radius_m - low_y_m_);
    for (std::ptrdiff_t row = cell_of(y_m - radius_m - low_y_m_); row <= last_row; ++row) {
      for (std::ptrdiff_t column = cell_of(x_m - radius_m - low_x_m_); column <= last_column; ++column) {
        const std::size_t cell = index(column, row);
        for (std::size_t i = starts_[cell]; i < starts_[cell + 1]; ++i) visit(bodies_[i]);
      }
    }
  }

 private:
  [[nodiscard]] std::ptrdiff_t cell_of(double offset_m) const {
    return std::clamp(static_cast<std::ptrdiff_t>(offset_m / cell_m_), std::ptrdiff_t{0}, cells_ - 1);
  }
  [[nodiscard]] std::ptrdiff_t column(const GroundPose& pose) const { return cell_of(pose.x_m - low_x_m_); }
  [[nodiscard]] std::ptrdiff_t row(const GroundPose& pose) const { return cell_of(pose.y_m - low_y_m_); }
  [[nodiscard]] std::size_t index(std::ptrdiff_t column, std::ptrdiff_t row) const {
    return static_cast<std::size_t>(row * cells_ + column);
  }

  /// The cells inside the grid whose larger distance from home in columns and rows is exactly `ring`.
  template <class Visit>
  void for_each_cell_of_ring(std::ptrdiff_t home_column, std::ptrdiff_t home_row, std::ptrdiff_t ring, Visit&& visit) const {
    const std::ptrdiff_t first = std::max(home_column - ring, std::ptrdiff_t{0});
    const std::ptrdiff_t last = std::min(home_column + ring, cells_ - 1);
    for (std::ptrdiff_t row = std::max(home_row - ring, std::ptrdiff_t{0}); row <= std::min(home_row + ring, cells_ - 1); ++row) {
      if (row == home_row - ring || row == home_row + ring) {
        for (std::ptrdiff_t column = first; column <= last; ++column) visit(index(column, row));
        continue;
      }
      if (home_column - ring >= 0) visit(index(home_column - ring, row));
      if (home_column + ring < cells_) visit(index(home_column + ring, row));
    }
  }

  double low_x_m_ = std::numeric_limits<double>::infinity();
  double low_y_m_ = std::numeric_limits<double>::infinity();
  double cell_m_ = 1.0;
  std::ptrdiff_t cells_ = 0;
  std::vector<std::size_t> starts_;  ///< bodies_[starts_[c]] to bodies_[starts_[c + 1]] stand in cell c, ascending
  std::vector<BodyIndex> bodies_;
};

}  // namespace trophic
