// SPDX-License-Identifier: MIT
// Finds the closest robot without visiting all of them, however rare acceptable robots are.
#pragma once

#include <trophic/population/search.hpp>
#include <trophic/population/spatial_grid.hpp>

namespace trophic {

/// From this number of robots on, a tree finds the closest robot faster than visiting each; both give the same result.
inline constexpr std::size_t tree_from_robots = 64;

/// A grid of robots under squares of 2 x 2 cells, 4 x 4, ..., each of which holds the marks of the robots in it. A search goes
/// outwards from the robot's own cell, as far as a closer one can be, and skips squares without the marks, so it hardly takes
/// longer with more robots. It gives exactly the result of visiting every robot, including ties. Positions are stored cell by
/// cell, because neighbouring robots are far apart in memory.
class SearchTree {
 public:
  SearchTree() = default;
  SearchTree(std::span<const GroundPose> poses, std::span<const Individual> robots) : grid_{poses} {
    for (std::ptrdiff_t side = grid_.side(); side > 0; side = side == 1 ? 0 : (side + 1) / 2) {
      levels_.push_back({side, std::vector<Marks>(static_cast<std::size_t>(side * side), 0)});
    }
    standing_.reserve(poses.size());
    for (const BodyIndex body : grid_.bodies()) {
      standing_.push_back({poses[body], mark_of(robots[body]), body});
      mark_squares(grid_.column(poses[body]), grid_.row(poses[body]), standing_.back().marks);
    }
  }

  /// Updates a body whose occupant, tag or activity changed. Must be called before the next search.
  void mark(BodyIndex body, const GroundPose& pose, const Individual& robot) {
    const std::ptrdiff_t column = grid_.column(pose);
    const std::ptrdiff_t row = grid_.row(pose);
    for (Standing& one : grid_.in_cell(std::span{standing_}, column, row)) {
      if (one.body == body) one.marks |= mark_of(robot);
    }
    mark_squares(column, row, mark_of(robot));
  }

  /// The body closest to `self`, which stands at `pose`, for which `accepts(body)` holds, excluding itself; at equal distances,
  /// the one with the lower index. `space`: as in View.
  template <class Accepts>
  [[nodiscard]] std::optional<BodyIndex> closest(BodyIndex self, const GroundPose& pose, Accepts&& accepts,
                                                 const Search& search = {}, const Space& space = {}) const {
    Nearest<std::remove_reference_t<Accepts>> nearest{*this, self, pose, space, accepts, search.among, search.within_m};
    if (levels_.empty() || (levels_.back().at(0, 0) & search.among) == 0) return std::nullopt;
    space.for_each_image(pose, [&](const GroundPose& image) {
      if (!grid_.may_reach(image, nearest.most_m, 0, 0, grid_.side())) return;
      nearest.from = image;
      nearest.own_column = grid_.column(image);
      nearest.own_row = grid_.row(image);
      nearest.look_around();
    });
    return nearest.body;
  }

  [[nodiscard]] BodyIndex by_place(std::size_t i) const { return standing_[i].body; }  ///< all bodies, cell by cell
  /// Calls `visit(body)` for every body within `radius_m` of a point and for some that are hardly farther away; on a torus for
  /// some twice. Bodies without an individual since the construction are left out.
  template <class Visit>
  void for_each_near(const GroundPose& point, double radius_m, Visit&& visit, const Space& space = {}) const {
    if (levels_.empty()) return;
    space.for_each_image(point, [&](const GroundPose& at) {
      grid_.for_each_cell_near(at.x_m, at.y_m, radius_m, [&](std::ptrdiff_t column, std::ptrdiff_t row) {
        for (const Standing& one : grid_.in_cell(std::span{standing_}, column, row)) {
          if (one.marks != 0 && grid_.may_be_within(at, one.pose, radius_m)) visit(one.body);
        }
      });
    });
  }

 private:
  struct Level {
    std::ptrdiff_t side;  ///< squares in a row
    std::vector<Marks> marks;
    [[nodiscard]] Marks at(std::ptrdiff_t column, std::ptrdiff_t row) const {
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
    Space space;
    Accepts& accepts;
    Marks among;
    double most_m;
    std::optional<BodyIndex> body = {};
    GroundPose from = {};  ///< an image of `pose`, with its cell
    std::ptrdiff_t own_column = 0;
    std::ptrdiff_t own_row = 0;

    /// Searches outwards from its own cell until no body beyond a square can be closer.
    void look_around() {
      look(0, own_column, own_row);
      for (std::size_t level = 0; level + 1 < tree.levels_.size(); ++level) {
        if (tree.grid_.encloses(from, most_m, own_column >> level, own_row >> level, std::ptrdiff_t{1} << level)) return;
        look_beside(level, own_column >> level, own_row >> level);
      }
    }

    void look(std::size_t level, std::ptrdiff_t column, std::ptrdiff_t row) {
      const Level& here = tree.levels_[level];
      if (column >= here.side || row >= here.side || (here.at(column, row) & among) == 0) return;
      if (!tree.grid_.may_reach(from, most_m, column, row, std::ptrdiff_t{1} << level)) return;
      if (level == 0) return look_in_cell(column, row);
      // The square nearest to the searching body comes first, so that the others are often too far.
      const std::ptrdiff_t near_column = std::clamp(own_column >> (level - 1), 2 * column, 2 * column + 1);
      const std::ptrdiff_t near_row = std::clamp(own_row >> (level - 1), 2 * row, 2 * row + 1);
      look(level - 1, near_column, near_row);
      look_beside(level - 1, near_column, near_row);
    }

    void look_beside(std::size_t level, std::ptrdiff_t column, std::ptrdiff_t row) {
      look(level, column ^ 1, row);
      look(level, column, row ^ 1);
      look(level, column ^ 1, row ^ 1);
    }

    void look_in_cell(std::ptrdiff_t column, std::ptrdiff_t row) {
      for (const Standing& other : tree.grid_.in_cell(std::span{tree.standing_}, column, row)) {
        if (other.body == self || (other.marks & among) == 0) continue;
        const double d = space.distance_m(pose, other.pose);
        const bool is_closer = d < most_m || (d == most_m && (!body || other.body < *body));
        if (!is_closer || !accepts(other.body)) continue;
        most_m = d;
        body = other.body;
      }
    }
  };

  /// The squares around a cell get the marks of a body in it.
  void mark_squares(std::ptrdiff_t column, std::ptrdiff_t row, Marks marks) {
    for (Level& level : levels_) {
      Marks& there = level.marks[static_cast<std::size_t>(row * level.side + column)];
      if ((there & marks) == marks) return;  // and so has every larger square
      there |= marks;
      column /= 2;
      row /= 2;
    }
  }

  SpatialGrid grid_;
  std::vector<Standing> standing_;  ///< cell by cell
  std::vector<Level> levels_;       ///< from single cells up to one square
};

}  // namespace trophic
