// SPDX-License-Identifier: MIT
// Definitions of search_tree.hpp.
#pragma once

#include <trophic/population/search_tree.hpp>

namespace trophic {

TROPHIC_INLINE SearchTree::SearchTree(std::span<const GroundPose> poses, std::span<const Individual> robots) : grid_{poses} {
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

TROPHIC_INLINE void SearchTree::mark(BodyIndex body, const GroundPose& pose, const Individual& robot) {
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

}  // namespace trophic
