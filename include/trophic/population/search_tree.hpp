// SPDX-License-Identifier: MIT
// Finds the closest robot without visiting all of them, however rare acceptable robots are.
#pragma once

#include <span>
#include <trophic/population/individual.hpp>
#include <trophic/population/search.hpp>
#include <trophic/population/spatial_grid.hpp>
#include <trophic/support/units.hpp>
#include <type_traits>

namespace trophic {

/// From this number of robots on, a tree finds the closest robot faster than a visit to each; both give the same result.
inline constexpr std::size_t tree_from_robots = 64;

/// Calls `visit` with a place and, on a torus of side `period_m`, with its eight images next to the square.
template <class Visit>
void for_each_image(const GroundPose& place, double period_m, Visit&& visit) {
  for (int image = 0; image < (period_m > 0.0 ? 9 : 1); ++image) {  // 0: the place itself
    visit(GroundPose{place.x_m + ((image + 1) % 3 - 1) * period_m, place.y_m + ((image / 3 + 1) % 3 - 1) * period_m});
  }
}

/// A grid of robots under squares of two times two cells, four times four, ..., each of which holds the marks of the robots in
/// it. A search visits the nearest squares first and skips those that are too far or lack the marks: its cost grows with the
/// logarithm of the number of robots. It gives exactly the result of visiting every robot, ties included. Positions are stored
/// cell by cell, because neighbouring robots are far apart in memory.
class SearchTree {
 public:
  SearchTree() = default;
  SearchTree(std::span<const GroundPose> poses, std::span<const Individual> robots) : grid_{poses} {
    for (std::ptrdiff_t side = grid_.side(); side > 0; side = side == 1 ? 0 : (side + 1) / 2) {
      levels_.push_back({side, std::vector<Marks>(static_cast<std::size_t>(side * side), 0)});
    }
    standing_.reserve(poses.size());
    for (std::ptrdiff_t row = 0; row < grid_.side(); ++row) {
      for (std::ptrdiff_t column = 0; column < grid_.side(); ++column) {
        for (const BodyIndex body : grid_.bodies_in(column, row)) {
          standing_.push_back({poses[body], mark_of(robots[body]), body});
          levels_[0].at(column, row) |= standing_.back().marks;
        }
      }
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

  /// Updates a body whose occupant, tag or activity changed. Must be called before the next search.
  void mark(BodyIndex body, const GroundPose& pose, const Individual& robot) {
    std::ptrdiff_t column = grid_.column(pose);
    std::ptrdiff_t row = grid_.row(pose);
    for (Standing& one : std::span{standing_}.subspan(grid_.first_in(column, row), grid_.bodies_in(column, row).size())) {
      if (one.body == body) one.marks |= mark_of(robot);
    }
    for (Level& level : levels_) {
      level.at(column, row) |= mark_of(robot);
      column /= 2;
      row /= 2;
    }
  }

  /// The body closest to `self`, which stands at `pose`, for which `accepts(body)` holds, excluding itself; on equal distance
  /// the lower index. `period_m`: as View's.
  template <class Accepts>
  [[nodiscard]] std::optional<BodyIndex> closest(BodyIndex self, const GroundPose& pose, Accepts&& accepts,
                                                 const Search& search = {}, double period_m = 0.0) const {
    Nearest<std::remove_reference_t<Accepts>> nearest{*this, self, pose, period_m, accepts, search.among, search.within_m};
    if (levels_.empty()) return std::nullopt;
    for_each_image(pose, period_m, [&](const GroundPose& image) {
      nearest.from = image;
      nearest.own_column = grid_.column(image);
      nearest.own_row = grid_.row(image);
      nearest.look(levels_.size() - 1, 0, 0);
    });
    return nearest.body;
  }

  [[nodiscard]] BodyIndex by_place(std::size_t i) const { return standing_[i].body; }  ///< all bodies, cell by cell
  /// Calls `visit(body)` for every body within `radius_m` of a point, and some that are farther away; some on a torus twice.
  template <class Visit>
  void for_each_near(const GroundPose& point, double radius_m, Visit&& visit, double period_m = 0.0) const {
    if (levels_.empty()) return;
    for_each_image(point, period_m, [&](const GroundPose& at) { grid_.for_each_near(at.x_m, at.y_m, radius_m, visit); });
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
  struct Standing {
    GroundPose pose;
    Marks marks;  ///< since construction: marks are never removed
    BodyIndex body;
  };
  /// The body found so far that is closest to `self`.
  template <class Accepts>
  struct Nearest {
    const SearchTree& tree;
    BodyIndex self;
    const GroundPose& pose;
    double period_m;
    Accepts& accepts;
    Marks among;
    double most_m;
    std::optional<BodyIndex> body = {};
    GroundPose from = {};  ///< an image of `pose`, with its cell
    std::ptrdiff_t own_column = 0;
    std::ptrdiff_t own_row = 0;

    void look(std::size_t level, std::ptrdiff_t column, std::ptrdiff_t row) {
      const Level& here = tree.levels_[level];
      if (column >= here.side || row >= here.side || (here.at(column, row) & among) == 0) return;
      if (!tree.grid_.may_reach(from, most_m, column, row, std::ptrdiff_t{1} << level)) return;
      if (level == 0) return look_in_cell(column, row);
      // The square nearest to the searching body first, so that the others are often too far.
      const auto nearest = [&](std::ptrdiff_t place, std::ptrdiff_t first) {
        return std::clamp(place >> (level - 1), first, first + 1);
      };
      const std::ptrdiff_t near_column = nearest(own_column, 2 * column);
      const std::ptrdiff_t near_row = nearest(own_row, 2 * row);
      const std::ptrdiff_t far_column = 4 * column + 1 - near_column;
      const std::ptrdiff_t far_row = 4 * row + 1 - near_row;
      look(level - 1, near_column, near_row);
      look(level - 1, far_column, near_row);
      look(level - 1, near_column, far_row);
      look(level - 1, far_column, far_row);
    }

    void look_in_cell(std::ptrdiff_t column, std::ptrdiff_t row) {
      const std::size_t bodies = tree.grid_.bodies_in(column, row).size();
      for (const Standing& other : std::span{tree.standing_}.subspan(tree.grid_.first_in(column, row), bodies)) {
        if (other.body == self || (other.marks & among) == 0) continue;
        const double d = distance_m(pose, other.pose, period_m);
        const bool is_closer = d < most_m || (d == most_m && (!body || other.body < *body));
        if (!is_closer || !accepts(other.body)) continue;
        most_m = d;
        body = other.body;
      }
    }
  };

  SpatialGrid grid_;
  std::vector<Standing> standing_;  ///< cell by cell
  std::vector<Level> levels_;       ///< from single cells to one square
};

}  // namespace trophic
