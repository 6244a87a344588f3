// SPDX-License-Identifier: MIT
// All robots in one MuJoCo model, stepped by mj_step: the reference for the fast modes.
#pragma once

#include <cstddef>
#include <numeric>
#include <span>
#include <trophic/backend/mujoco/group_step.hpp>
#include <vector>

namespace trophic::backend::mujoco {

class OneModel {
 public:
  OneModel(const RobotModel& robot, const Arena& arena, const Physics& physics, std::size_t robots, BoxDepth box_depth)
      : all_(robots), compiled_{robot, arena, physics, Scene{.box_depth = box_depth}, robots, 1} {
    std::iota(all_.begin(), all_.end(), std::size_t{0});
  }

  [[nodiscard]] const Layout& layout() const { return compiled_.layout(); }

  /// Takes all steps from the states in `from` to those in `to`; a result that is not `done` leaves `to` undefined.
  [[nodiscard]] GroupResult advance(const RobotStates& from, std::span<const double> targets_rad, std::size_t steps,
                                    RobotStates& to) {
    GroupResult result;
    do {
      result = step_group(compiled_, all_, targets_rad, {}, steps, from, to);
    } while (result.end == GroupResult::End::buffers_full && compiled_.grow());
    return result;
  }

 private:
  std::vector<std::size_t> all_;
  CompiledModel compiled_;
};

}  // namespace trophic::backend::mujoco
