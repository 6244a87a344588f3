// SPDX-License-Identifier: MIT
// All robots in one MuJoCo model, stepped by mj_step: the reference for the fast modes.
#pragma once

#include <cstddef>
#include <memory>
#include <numeric>
#include <trophic/backend/mujoco/group_step.hpp>
#include <vector>

namespace trophic::backend::mujoco {

class OneModel {
 public:
  OneModel(const RobotModel& robot, const Arena& arena, const Physics& physics, std::size_t robots, BoxDepth box_depth)
      : bodies_(robots, robot), arena_{arena}, physics_{physics}, box_depth_{box_depth} {
    std::vector<std::size_t> all(robots);
    std::iota(all.begin(), all.end(), std::size_t{0});
    compile(std::move(all));
  }

  /// Gives a robot a different body; its kind is not used.
  [[nodiscard]] std::size_t set_body(std::size_t robot, const RobotModel& model) {
    bodies_[robot] = model;
    compiled_.reset();
    return 0;
  }

  /// Takes all steps from the states in `from` to those in `to`; a result that is not `done` leaves `to` undefined.
  [[nodiscard]] GroupResult advance(const RobotStates& from, const Rows& targets_rad, std::size_t steps, RobotStates& to) {
    std::vector<std::size_t> there;
    for (std::size_t robot = 0; robot < bodies_.size(); ++robot) {
      if (from.is_there(robot)) there.push_back(robot);
    }
    if (there.empty()) return {};
    if (!compiled_ || there != there_) compile(std::move(there));
    GroupResult result;
    do {
      result = step_group(*compiled_, there_, targets_rad, {}, steps, from, to);
    } while (result.end == GroupResult::End::buffers_full && compiled_->grow());
    return result;
  }

 private:
  void compile(std::vector<std::size_t> there) {
    there_ = std::move(there);
    std::vector<const RobotModel*> bodies;
    for (const std::size_t robot : there_) bodies.push_back(&bodies_[robot]);
    compiled_ = std::make_unique<CompiledModel>(bodies, arena_, physics_, Scene{.box_depth = box_depth_}, 1);
  }

  std::vector<RobotModel> bodies_;
  Arena arena_;
  Physics physics_;
  BoxDepth box_depth_;
  std::vector<std::size_t> there_;  ///< the robots of the compiled model
  std::unique_ptr<CompiledModel> compiled_;
};

}  // namespace trophic::backend::mujoco
