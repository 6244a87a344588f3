// SPDX-License-Identifier: MIT
// Finds the closest robot without looking at all of them, however rare it is whom one looks for.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <trophic/population/individual.hpp>
#include <trophic/population/search.hpp>
#include <trophic/population/spatial_grid.hpp>
#include <trophic/support/units.hpp>
#include <vector>

namespace trophic {

/// A grid of robots under squares of two times two cells, four times four, ..., each of which knows the marks of those who stand
/// in it. A search goes into the nearest squares first and passes over those that are too far or lack the marks: its cost grows
/// with the logarithm of the number of robots. Gives exactly what looking at every robot gives, ties included. Holds indices
/// only: the poses that it was built from must be given again.
class SearchTree {
 public:
  SearchTree() = default;
  SearchTree(std::span<const GroundPose> poses, std::span<const Individual> robots) : grid_{poses} {
    for (std::ptrdiff_t side = grid_.side(); side > 0; side = side == 1 ? 0 : (side + 1) / 2) {
      levels_.push_back({side, std::vector<Marks>(static_cast<std::size_t>(side * side), 0)});
    }
    for (BodyIndex body = 0; body < poses.size(); ++body) {
      levels_[0].at(grid_.column(poses[body]), grid_.row(poses[body])) |= mark_of(robots[body]);
    }
    for (std::size_t level = 1; level < levels_.size(); ++level) {
      const std::ptrdiff_t side = levels_[level - 1].side;
      for (std::ptrdiff_t row = 0; row < side; ++row) {
        for (std::ptrdiff_t column = 0; column < side; ++column) {
          levels_[level].at(column / 2, row / 2) |= levels_[level - 1].at(column, row);
        }
      }
    }
  }

  /// Somebody else lives in a body, or shows another tag, or is active now. Must be told before the next search.
  void mark(const GroundPose& pose, const Individual& robot) {
    std::ptrdiff_t column = grid_.column(pose);
    std::ptrdiff_t row = grid_.row(pose);
    for (Level& level : levels_) {
      level.at(column, row) |= mark_of(robot);
      column /= 2;
      row /= 2;
    }
  }

  /// The body closest to `self` for which `accepts(body)` holds, itself excluded; on equal distance the lower index.
  template <class Accepts>
  [[nodiscard]] std::optional<BodyIndex> closest(BodyIndex self, std::span<const GroundPose> poses, Accepts&& accepts,
                                                 const Search& search = {}) const {
    Found found{.most_m = search.within_m, .body = {}};
    if (!levels_.empty()) look(levels_.size() - 1, 0, 0, self, poses, accepts, search.among, found);
    return found.body;
  }

 private:
  struct Level {
    std::ptrdiff_t side;  ///< squares in a row
    std::vector<Marks> marks;
    [[nodiscard]] Marks& at(std::ptrdiff_t column, std::ptrdiff_t row) {
      return marks[static_cast<std::size_t>(row * side + column)];
    }
    [[nodiscard]] const Marks& at(std::ptrdiff_t column, std::ptrdiff_t row) const {
      return marks[static_cast<std::size_t>(row * side + column)];
    }
  };
  struct Found {
    double most_m;
    std::optional<BodyIndex> body;
  };

  template <class Accepts>
  void look(std::size_t level, std::ptrdiff_t column, std::ptrdiff_t row, BodyIndex self, std::span<const GroundPose> poses,
            Accepts& accepts, Marks among, Found& found) const {
    const Level& here = levels_[level];
    if (column >= here.side || row >= here.side || (here.at(column, row) & among) == 0) return;
    if (!grid_.may_reach(poses[self], found.most_m, column, row, std::ptrdiff_t{1} << level)) return;
    if (level == 0) {
      for (const BodyIndex body : grid_.bodies_in(column, row)) {
        if (body == self || !accepts(body)) continue;
        const double d = distance_m(poses[self], poses[body]);
        if (d < found.most_m || (d == found.most_m && (!found.body || body < *found.body))) found = {d, body};
      }
      return;
    }
    // The square that is nearest to self first, so that the others are often too far.
    const auto nearest = [&](std::ptrdiff_t home, std::ptrdiff_t first) {
      return std::clamp(home >> (level - 1), first, first + 1);
    };
    const std::ptrdiff_t near_column = nearest(grid_.column(poses[self]), 2 * column);
    const std::ptrdiff_t near_row = nearest(grid_.row(poses[self]), 2 * row);
    const std::ptrdiff_t far_column = 4 * column + 1 - near_column;
    const std::ptrdiff_t far_row = 4 * row + 1 - near_row;
    look(level - 1, near_column, near_row, self, poses, accepts, among, found);
    look(level - 1, far_column, near_row, self, poses, accepts, among, found);
    look(level - 1, near_column, far_row, self, poses, accepts, among, found);
    look(level - 1, far_column, far_row, self, poses, accepts, among, found);
  }

  SpatialGrid grid_;
  std::vector<Level> levels_;  ///< the first of cells, the last of one square
};

}  // namespace trophic
