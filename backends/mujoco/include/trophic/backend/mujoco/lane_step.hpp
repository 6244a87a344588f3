// SPDX-License-Identifier: MIT
// Steps up to four robots that touch nobody else by the kernel, and by MuJoCo where the kernel declines.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <trophic/backend/mujoco/group_step.hpp>
#include <trophic/backend/mujoco/kernel/step.hpp>
#include <vector>

namespace trophic::backend::mujoco {

/// The kernel with the working memory of each thread.
class LaneStepper {
 public:
  /// `constants` must be those of one robot in an arena with its walls.
  LaneStepper(kernel::KernelModel constants, std::size_t threads)
      : constants_{std::make_unique<kernel::KernelModel>(std::move(constants))}, scratch_(threads) {}

  /// Takes `steps` steps of at most four robots, none of which can touch another robot. `single` is a model of one robot with all
  /// that it can touch, in which MuJoCo takes the steps that the kernel leaves to it. Otherwise as `step_group`.
  [[nodiscard]] GroupResult advance(CompiledModel& single, std::size_t thread, std::span<const std::size_t> robots,
                                    std::span<const double> targets_rad, std::span<const double> slack_m, std::size_t steps,
                                    const RobotStates& from, RobotStates& to) {
    if (!scratch_[thread]) scratch_[thread] = std::make_unique<Scratch>(*constants_);
    kernel::LaneState& lanes = scratch_[thread]->lanes;
    const std::size_t hinges = constants_->hinges.size();
    kernel::Real slack_square{};
    for (std::size_t lane = 0; lane < robots.size(); ++lane) {
      const std::size_t robot = robots[lane];
      lanes.load(lane, from.numbers(robot), targets_rad.subspan(robot * hinges, hinges));
      slack_square[lane] = slack_m[robot] * slack_m[robot];
    }
    const kernel::Real start_x = lanes.position[0];
    const kernel::Real start_y = lanes.position[1];

    const unsigned all = (1u << robots.size()) - 1;
    for (std::size_t step = 0; step < steps; ++step) {
      const unsigned left = all & ~step_(*constants_, lanes, scratch_[thread]->work, all);
      for (std::size_t lane = 0; left != 0 && lane < robots.size(); ++lane) {
        if ((left & (1u << lane)) == 0) continue;
        GroupResult result = step_by_mujoco(single, thread, robots[lane], lanes, lane, to);
        result.steps = step;
        if (result.end != GroupResult::End::done) return result;
      }
      const kernel::Real dx = lanes.position[0] - start_x;
      const kernel::Real dy = lanes.position[1] - start_y;
      const unsigned outside = all & kernel::lane_bits(dx * dx + dy * dy > slack_square);
      for (std::size_t lane = 0; outside != 0 && lane < robots.size(); ++lane) {
        if ((outside & (1u << lane)) != 0) {
          return {.end = GroupResult::End::left_disc, .steps = step, .robot = robots[lane], .what = {}};
        }
      }
    }
    for (std::size_t lane = 0; lane < robots.size(); ++lane) {
      lanes.store(lane, to.numbers(robots[lane]));
      if (!to.sound(robots[lane])) {
        return {.end = GroupResult::End::diverged, .steps = steps, .robot = robots[lane], .what = "a number is NaN or too large"};
      }
    }
    return {};
  }

 private:
  struct Scratch {
    explicit Scratch(const kernel::KernelModel& constants) : lanes{constants}, work{constants} {}
    kernel::LaneState lanes;
    kernel::Workspace work;
  };

  /// One mj_step of the robot in a lane; `to` holds its numbers on the way.
  [[nodiscard]] static GroupResult step_by_mujoco(CompiledModel& single, std::size_t thread, std::size_t robot,
                                                  kernel::LaneState& lanes, std::size_t lane, RobotStates& to) {
    const EngineGuard guard;
    mjData& data = single.data(thread);
    lanes.store(lane, to.numbers(robot));
    to.load(robot, 0, data);
    for (std::size_t i = 0; i < lanes.target.size(); ++i) data.ctrl[i] = lanes.target[i][lane];
    GroupResult result;
    try {
      mj_step(&single.model(), &data);
      result = read_warnings(single, data, {&robot, 1});
    } catch (const EngineError& error) {
      result = {.end = GroupResult::End::diverged, .robot = robot, .what = error.what()};
    }
    if (result.end == GroupResult::End::done && !to.store(robot, 0, data)) {
      result = {.end = GroupResult::End::diverged, .robot = robot, .what = "a number is NaN or too large"};
    }
    if (result.end != GroupResult::End::done) {
      mj_resetData(&single.model(), &data);
      return result;
    }
    lanes.load(lane, to.numbers(robot));
    return {};
  }

  std::unique_ptr<const kernel::KernelModel> constants_;
  kernel::StepFunction step_ = kernel::fastest_step();
  std::vector<std::unique_ptr<Scratch>> scratch_;
};

}  // namespace trophic::backend::mujoco
