// SPDX-License-Identifier: MIT
// Finds the closest robot without visiting all of them, however rare acceptable robots are.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <trophic/population/individual.hpp>
#include <trophic/population/search.hpp>
#include <trophic/population/spatial_grid.hpp>
#include <trophic/support/linkage.hpp>
#include <trophic/support/units.hpp>
#include <vector>

namespace trophic {

/// From this number of robots on, a tree finds the closest robot faster than a visit to each; both give the same result.
inline constexpr std::size_t tree_from_robots = 64;

/// A grid of robots under squares of two times two cells, four times four, ..., each of which holds the marks of the robots in
/// it. A search visits the nearest squares first and skips those that are too far or lack the marks: its cost grows with the
/// logarithm of the number of robots. It gives exactly the result of visiting every robot, ties included. Positions are stored
/// cell by cell, because neighbouring robots are far apart in memory.
class SearchTree {
 public:
  SearchTree() = default;
  SearchTree(std::span<const GroundPose> poses, std::span<const Individual> robots);

  /// Updates a body whose occupant, tag or activity changed. Must be called before the next search.
  void mark(BodyIndex body, const GroundPose& pose, const Individual& robot);

  /// The body closest to `self`, which stands at `pose`, for which `accepts(body)` holds, excluding itself; on equal distance
  /// the lower index.
  template <class Accepts>
  [[nodiscard]] std::optional<BodyIndex> closest(BodyIndex self, const GroundPose& pose, Accepts&& accepts,
                                                 const Search& search = {}) const {
    Found found{.most_m = search.within_m, .body = {}};
    const Home home{.self = self, .pose = pose, .column = grid_.column(pose), .row = grid_.row(pose)};
    if (!levels_.empty()) look(levels_.size() - 1, 0, 0, home, accepts, search.among, found);
    return found.body;
  }

  /// Calls `visit(body)` once for every body within `radius_m` of a point, and for some that are farther away.
  template <class Visit>
  void for_each_near(const GroundPose& point, double radius_m, Visit&& visit) const {
    if (!levels_.empty()) grid_.for_each_near(point.x_m, point.y_m, radius_m, visit);
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
  /// The searching body and its position.
  struct Home {
    BodyIndex self;
    const GroundPose& pose;
    std::ptrdiff_t column;
    std::ptrdiff_t row;
  };
  struct Found {
    double most_m;
    std::optional<BodyIndex> body;
  };

  template <class Accepts>
  void look(std::size_t level, std::ptrdiff_t column, std::ptrdiff_t row, const Home& home, Accepts& accepts, Marks among,
            Found& found) const {
    const Level& here = levels_[level];
    if (column >= here.side || row >= here.side || (here.at(column, row) & among) == 0) return;
    if (!grid_.may_reach(home.pose, found.most_m, column, row, std::ptrdiff_t{1} << level)) return;
    if (level == 0) {
      for (const Standing& other :
           std::span{standing_}.subspan(grid_.first_in(column, row), grid_.bodies_in(column, row).size())) {
        if (other.body == home.self || (other.marks & among) == 0) continue;
        const double d = distance_m(home.pose, other.pose);
        const bool is_closer = d < found.most_m || (d == found.most_m && (!found.body || other.body < *found.body));
        if (is_closer && accepts(other.body)) found = {d, other.body};
      }
      return;
    }
    // The square nearest to the searching body first, so that the others are often too far.
    const auto nearest = [&](std::ptrdiff_t place, std::ptrdiff_t first) {
      return std::clamp(place >> (level - 1), first, first + 1);
    };
    const std::ptrdiff_t near_column = nearest(home.column, 2 * column);
    const std::ptrdiff_t near_row = nearest(home.row, 2 * row);
    const std::ptrdiff_t far_column = 4 * column + 1 - near_column;
    const std::ptrdiff_t far_row = 4 * row + 1 - near_row;
    look(level - 1, near_column, near_row, home, accepts, among, found);
    look(level - 1, far_column, near_row, home, accepts, among, found);
    look(level - 1, near_column, far_row, home, accepts, among, found);
    look(level - 1, far_column, far_row, home, accepts, among, found);
  }

  SpatialGrid grid_;
  std::vector<Standing> standing_;  ///< cell by cell
  std::vector<Level> levels_;       ///< from single cells to one square
};

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/population/search_tree.ipp>
#endif
