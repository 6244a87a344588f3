// SPDX-License-Identifier: MIT
// Finds nearby robots without visiting all of them.
#pragma once

#include <cmath>
#include <span>
#include <trophic/population/individual.hpp>
#include <trophic/support/units.hpp>

namespace trophic {

/// Robots sorted into the square cells of a grid over their bounding box, about two per cell. Holds only indices.
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
    rounding_m_ = 1e-9 * (std::abs(low_x_m_) + std::abs(low_y_m_) + side_m);
    starts_.assign(static_cast<std::size_t>(cells_ * cells_) + 1, 0);
    std::vector<std::size_t> cells;  // of the bodies
    cells.reserve(poses.size());
    for (const GroundPose& pose : poses) ++starts_[cells.emplace_back(index(column(pose), row(pose))) + 1];
    for (std::size_t cell = 1; cell < starts_.size(); ++cell) starts_[cell] += starts_[cell - 1];
    bodies_.resize(poses.size());
    std::vector<std::size_t> next(starts_.begin(), starts_.end() - 1);
    for (BodyIndex body = 0; body < poses.size(); ++body) bodies_[next[cells[body]]++] = body;
  }

  /// The number of cells in a row, and the cell of a robot (the closest cell for one outside the box).
  [[nodiscard]] std::ptrdiff_t side() const { return cells_; }
  [[nodiscard]] std::ptrdiff_t column(const GroundPose& pose) const { return cell_of(pose.x_m - low_x_m_); }
  [[nodiscard]] std::ptrdiff_t row(const GroundPose& pose) const { return cell_of(pose.y_m - low_y_m_); }
  /// The bodies cell by cell, ascending in each cell, and the range of a cell in a list in that order.
  [[nodiscard]] std::span<const BodyIndex> bodies() const { return bodies_; }
  template <class T>
  [[nodiscard]] std::span<T> in_cell(std::span<T> ordered, std::ptrdiff_t column, std::ptrdiff_t row) const {
    const std::size_t cell = index(column, row);
    return ordered.subspan(starts_[cell], starts_[cell + 1] - starts_[cell]);
  }
  /// Returns false only if every body in the given square of `cells` x `cells` cells is farther than `distance_m`.
  [[nodiscard]] bool may_reach(const GroundPose& from, double distance_m, std::ptrdiff_t column, std::ptrdiff_t row,
                               std::ptrdiff_t cells) const {
    const double square_m = static_cast<double>(cells) * cell_m_;
    const auto gap_m = [&](double offset_m, std::ptrdiff_t place) {
      const double low_m = static_cast<double>(place) * square_m;
      return std::max({low_m - offset_m, offset_m - low_m - square_m, 0.0});
    };
    const double dx = gap_m(from.x_m - low_x_m_, column);
    const double dy = gap_m(from.y_m - low_y_m_, row);
    const double reach_m = distance_m + rounding_m_;
    return dx * dx + dy * dy <= reach_m * reach_m;
  }

  /// Returns true only if every body within `distance_m` is in the given square.
  [[nodiscard]] bool encloses(const GroundPose& from, double distance_m, std::ptrdiff_t column, std::ptrdiff_t row,
                              std::ptrdiff_t cells) const {
    const double half_m = 0.5 * static_cast<double>(cells) * cell_m_;
    const auto off_m = [&](double offset_m, std::ptrdiff_t at) {
      return std::abs(offset_m - half_m * static_cast<double>(2 * at + 1));
    };
    return std::max(off_m(from.x_m - low_x_m_, column), off_m(from.y_m - low_y_m_, row)) < half_m - distance_m - rounding_m_;
  }

  /// Returns false only if two places are farther apart than `distance_m`.
  [[nodiscard]] bool may_be_within(const GroundPose& a, const GroundPose& b, double distance_m) const {
    const double dx = a.x_m - b.x_m;
    const double dy = a.y_m - b.y_m;
    const double reach_m = distance_m + rounding_m_;
    return dx * dx + dy * dy <= reach_m * reach_m;
  }

  /// Calls `visit(column, row)` once for every cell with a body within `radius_m` of a point, and for some others.
  template <class Visit>
  void for_each_cell_near(double x_m, double y_m, double radius_m, const Visit& visit) const {
    const std::ptrdiff_t last_column = cell_of(x_m + radius_m - low_x_m_);
    const std::ptrdiff_t last_row = cell_of(y_m + radius_m - low_y_m_);
    for (std::ptrdiff_t row = cell_of(y_m - radius_m - low_y_m_); row <= last_row; ++row) {
      for (std::ptrdiff_t column = cell_of(x_m - radius_m - low_x_m_); column <= last_column; ++column) visit(column, row);
    }
  }
  /// Calls `visit(body)` once for every body within `radius_m` of a point, and for some that are farther away.
  template <class Visit>
  void for_each_near(double x_m, double y_m, double radius_m, const Visit& visit) const {
    for_each_cell_near(x_m, y_m, radius_m, [&](std::ptrdiff_t column, std::ptrdiff_t row) {
      for (const BodyIndex body : in_cell(bodies(), column, row)) visit(body);
    });
  }

 private:
  [[nodiscard]] std::ptrdiff_t cell_of(double offset_m) const {
    return std::clamp(static_cast<std::ptrdiff_t>(offset_m / cell_m_), std::ptrdiff_t{0}, cells_ - 1);
  }
  [[nodiscard]] std::size_t index(std::ptrdiff_t column, std::ptrdiff_t row) const {
    return static_cast<std::size_t>(row * cells_ + column);
  }

  double low_x_m_ = std::numeric_limits<double>::infinity();
  double low_y_m_ = std::numeric_limits<double>::infinity();
  double cell_m_ = 1.0;
  double rounding_m_ = 0.0;  ///< exceeds the rounding error at the edge of a square
  std::ptrdiff_t cells_ = 0;
  std::vector<std::size_t> starts_;  ///< bodies_[starts_[c]] to bodies_[starts_[c + 1]] are in cell c, ascending
  std::vector<BodyIndex> bodies_;
};

}  // namespace trophic
