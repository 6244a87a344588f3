// SPDX-License-Identifier: MIT
// Finds the robots that touch others, from a world's state in a separate model.
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <mujoco/worlds.hpp>
#include <set>
#include <string_view>
#include <trophic/backend/mujoco/compiled_model.hpp>
#include <trophic/backend/mujoco/engine.hpp>
#include <trophic/backend/mujoco/mjcf.hpp>
#include <trophic/backend/mujoco/robot_states.hpp>
#include <utility>

namespace trophic::test {

class TouchWatch {
 public:
  TouchWatch(const RobotModel& robot, const Arena& arena, std::size_t robots)
      : compiled_{robot, arena, Physics{}, backend::mujoco::Scene{}, robots, 1}, states_{compiled_.layout(), robots} {}

  /// Notes the robots that touch another one now.
  void look(const backend::Mujoco& backend) {
    const backend::mujoco::EngineGuard guard;
    states_.set_values(backend.save().robots);
    const mjData* seen = &forward();
    while (seen->warning[mjWARN_CONTACTFULL].number + seen->warning[mjWARN_CNSTRFULL].number > 0 && compiled_.grow())
      seen = &forward();
    const mjData& data = *seen;
    pairs_.clear();
    at_wall_.clear();
    for (int i = 0; i < data.ncon; ++i) {
      const int one = robot_of(data.contact[i].geom1);
      const int other = robot_of(data.contact[i].geom2);
      if (one < 0 && is_wall(data, data.contact[i].geom1)) at_wall_.insert(other);
      if (other < 0 && is_wall(data, data.contact[i].geom2)) at_wall_.insert(one);
      if (one < 0 || other < 0 || one == other) continue;
      touched_.insert({one, other});
      pairs_.insert({std::min(one, other), std::max(one, other)});
    }
    most_rows_ = std::max(most_rows_, data.nefc);
  }

  [[nodiscard]] const std::set<int>& touched() const { return touched_; }
  /// Pairs of robots that touched, the lower number first, and robots that touched a wall, at the last look.
  [[nodiscard]] const std::set<std::pair<int, int>>& pairs() const { return pairs_; }
  [[nodiscard]] const std::set<int>& at_wall() const { return at_wall_; }
  [[nodiscard]] int most_rows() const { return most_rows_; }
  [[nodiscard]] std::size_t room() const { return static_cast<std::size_t>(compiled_.model().njmax); }

 private:
  mjData& forward() {
    mjData& data = compiled_.data(0);
    for (std::size_t i = 0; i < states_.robots(); ++i) states_.load(i, compiled_.shares()[i], data);
    mj_fwdPosition(&compiled_.model(), &data);
    return data;
  }

  /// Whether geometry that belongs to no robot is a fixed plane.
  [[nodiscard]] static bool is_wall(const mjData& data, int geom) { return std::abs(data.geom_xmat[9 * geom + 8]) < 0.5; }

  /// -1 for floor and walls.
  [[nodiscard]] int robot_of(int geom) const {
    const mjModel& model = compiled_.model();
    const int body = model.geom_bodyid[geom];
    if (body == 0) return -1;
    const std::string_view name{mj_id2name(&model, mjOBJ_BODY, model.body_rootid[body])};
    int robot = -1;
    std::from_chars(name.data() + std::string_view{"robot"}.size(), name.data() + name.size(), robot);
    return robot;
  }

  backend::mujoco::CompiledModel compiled_;
  backend::mujoco::RobotStates states_;
  std::set<int> touched_;
  std::set<std::pair<int, int>> pairs_;
  std::set<int> at_wall_;
  int most_rows_ = 0;
};

}  // namespace trophic::test
