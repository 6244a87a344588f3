// SPDX-License-Identifier: MIT
// Divides robots into crews, whose robots one thread steps together.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <trophic/backend/clusters.hpp>
#include <trophic/backend/mujoco/kernel/crew.hpp>
#include <vector>

namespace trophic::backend::mujoco {

/// The seats of robots in a crew. Bodies of a team have one shape; robots that may touch are in one crew.
struct CrewPlan {
  struct Team {
    std::size_t shape;
    std::array<std::size_t, kernel::lane_count> robots;
    std::size_t used;
    [[nodiscard]] std::size_t room() const { return kernel::lane_count - used; }
  };
  std::vector<Team> teams;
  std::vector<kernel::Seat> order;  ///< group by group, ascending in each
  std::vector<std::array<kernel::Seat, 2>> neighbours;

  [[nodiscard]] std::size_t robot(const kernel::Seat& seat) const { return teams[seat.team].robots[seat.lane]; }
  [[nodiscard]] std::size_t robots() const { return order.size(); }
};

/// Fills crews with groups of robots, largest groups first.
class CrewPlanner {
 public:
  /// `groups`: robots, each ascending, that may touch each other; `discs`: robots whose discs do not touch cannot. `shape_of`
  /// returns the number of a body's shape.
  template <class ShapeOf>
  [[nodiscard]] std::span<const CrewPlan> plan(std::span<const std::vector<std::size_t>> groups, std::span<const Disc> discs,
                                               const ShapeOf& shape_of) {
    count_ = 0;
    for (OpenTeams& open : open_) open = {};
    for (const std::vector<std::size_t>& group : groups) {
      if (group.size() == 1) {
        seat_alone(group.front(), shape_of(group.front()));
      } else {
        seat_group(group, discs, shape_of);
      }
    }
    return {crews_.data(), count_};
  }

 private:
  /// Teams of one shape in the order in which they were made. None before `first` has room.
  struct OpenTeams {
    std::vector<std::array<std::size_t, 2>> teams;  ///< crew and team
    std::size_t first = 0;
  };

  CrewPlan& add_crew() {
    if (count_ == crews_.size()) crews_.emplace_back();
    CrewPlan& crew = crews_[count_++];
    crew.teams.clear();
    crew.order.clear();
    crew.neighbours.clear();
    return crew;
  }

  OpenTeams& open(std::size_t shape) {
    if (shape >= open_.size()) open_.resize(shape + 1);
    return open_[shape];
  }

  kernel::Seat seat(CrewPlan& crew, std::size_t team, std::size_t robot) {
    CrewPlan::Team& own = crew.teams[team];
    own.robots[own.used] = robot;
    const kernel::Seat place = {team, own.used++};
    crew.order.push_back(place);
    return place;
  }

  std::size_t add_team(CrewPlan& crew, std::size_t shape) {
    crew.teams.push_back({shape, {}, 0});
    open(shape).teams.push_back({count_ - 1, crew.teams.size() - 1});
    return crew.teams.size() - 1;
  }

  /// A robot that cannot touch others goes into any team of its shape.
  void seat_alone(std::size_t robot, std::size_t shape) {
    OpenTeams& own = open(shape);
    const auto room = [&](const std::array<std::size_t, 2>& at) { return crews_[at[0]].teams[at[1]].room(); };
    while (own.first < own.teams.size() && room(own.teams[own.first]) == 0) ++own.first;
    if (own.first == own.teams.size()) add_team(add_crew(), shape);
    const auto [crew, team] = open(shape).teams[open(shape).first];
    seat(crews_[crew], team, robot);
  }

  /// The last team of a shape in a crew, or the number of its teams.
  static std::size_t last_team(const CrewPlan& crew, std::size_t shape) {
    const auto last = std::find_if(crew.teams.rbegin(), crew.teams.rend(), [&](const auto& team) { return team.shape == shape; });
    return last == crew.teams.rend() ? crew.teams.size() : static_cast<std::size_t>(crew.teams.rend() - last) - 1;
  }

  /// A group goes into the last crew if that has room for all of it, else into a new one.
  template <class ShapeOf>
  void seat_group(std::span<const std::size_t> group, std::span<const Disc> discs, const ShapeOf& shape_of) {
    const auto has_room = [&](std::size_t robot) {
      const std::size_t shape = shape_of(robot);
      const CrewPlan& crew = crews_[count_ - 1];
      const std::size_t team = last_team(crew, shape);
      const auto needed = std::ranges::count(group, shape, shape_of);
      return team < crew.teams.size() && crew.teams[team].room() >= static_cast<std::size_t>(needed);
    };
    CrewPlan& crew = count_ > 0 && std::ranges::all_of(group, has_room) ? crews_[count_ - 1] : add_crew();
    const std::size_t first = crew.order.size();
    for (const std::size_t robot : group) {
      std::size_t team = last_team(crew, shape_of(robot));
      if (team == crew.teams.size() || crew.teams[team].room() == 0) team = add_team(crew, shape_of(robot));
      seat(crew, team, robot);
    }
    for (std::size_t b = 1; b < group.size(); ++b) {
      for (std::size_t a = 0; a < b; ++a) {
        if (touch(discs[group[a]], discs[group[b]])) crew.neighbours.push_back({crew.order[first + a], crew.order[first + b]});
      }
    }
  }

  std::vector<CrewPlan> crews_;
  std::size_t count_ = 0;
  std::vector<OpenTeams> open_;
};

}  // namespace trophic::backend::mujoco
