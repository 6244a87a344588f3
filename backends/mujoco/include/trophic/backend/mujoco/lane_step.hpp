// SPDX-License-Identifier: MIT
// Steps up to four robots by the kernel, and by MuJoCo where the kernel declines.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <span>
#include <trophic/backend/mujoco/group_step.hpp>
#include <trophic/backend/mujoco/kernel/step.hpp>
#include <trophic/backend/mujoco/kernel/workspace.hpp>
#include <utility>
#include <vector>

namespace trophic::backend::mujoco {

/// Groups of robots, each ascending, that share the lanes of the kernel. Robots of different groups cannot touch.
class LaneSet {
 public:
  /// A group in consecutive lanes, and its model, in which MuJoCo takes the steps that the kernel leaves to it.
  struct Group {
    std::size_t first_lane;
    std::size_t robots;
    CompiledModel* model;
  };

  [[nodiscard]] std::size_t room() const { return kernel::lane_count - used_; }
  void add(std::span<const std::size_t> robots, CompiledModel& model) {
    groups_[group_count_++] = {used_, robots.size(), &model};
    for (const std::size_t robot : robots) robots_[used_++] = robot;
  }

  [[nodiscard]] std::span<const std::size_t> robots() const { return {robots_.data(), used_}; }
  [[nodiscard]] std::span<const std::size_t> robots(const Group& group) const {
    return robots().subspan(group.first_lane, group.robots);
  }
  [[nodiscard]] std::span<const Group> groups() const { return {groups_.data(), group_count_}; }

 private:
  std::array<std::size_t, kernel::lane_count> robots_{};
  std::array<Group, kernel::lane_count> groups_{};
  std::size_t used_ = 0;
  std::size_t group_count_ = 0;
};

/// Distributes groups of at most as many robots as there are lanes, largest groups first. `model_of` gives a group's model.
template <class ModelOf>
void fill_lanes(std::span<const std::vector<std::size_t>> groups, const ModelOf& model_of, std::vector<LaneSet>& sets) {
  sets.clear();
  std::size_t open = 0;  // no set before it has room
  for (const std::vector<std::size_t>& group : groups) {
    if (group.size() > 1) {
      if (sets.empty() || sets.back().room() < group.size()) sets.emplace_back();
      sets.back().add(group, model_of(group));
      continue;
    }
    while (open < sets.size() && sets[open].room() == 0) ++open;
    if (open == sets.size()) sets.emplace_back();
    sets[open].add(group, model_of(group));
  }
}

/// The kernel with the working memory of each thread.
class LaneStepper {
 public:
  /// `constants` must be those of one robot in an arena with its walls.
  LaneStepper(kernel::KernelModel constants, std::size_t threads)
      : constants_{std::make_unique<kernel::KernelModel>(std::move(constants))}, scratch_(threads) {}

  /// Takes `steps` steps of the robots in a set. Otherwise as `step_group`.
  [[nodiscard]] GroupResult advance(const LaneSet& set, std::size_t thread, std::span<const double> targets_rad,
                                    std::span<const double> slack_m, std::size_t steps, const RobotStates& from,
                                    RobotStates& to) {
    if (!scratch_[thread]) {
      const EngineGuard guard;
      scratch_[thread] = std::make_unique<Scratch>(*constants_);
    }
    Scratch& scratch = *scratch_[thread];
    kernel::LaneState& lanes = scratch.lanes;
    const std::span<const std::size_t> robots = set.robots();
    const std::size_t hinges = constants_->hinges.size();
    kernel::Real slack_square{};
    for (std::size_t lane = 0; lane < robots.size(); ++lane) {
      const std::size_t robot = robots[lane];
      lanes.load(lane, from.numbers(robot), targets_rad.subspan(robot * hinges, hinges));
      slack_square[lane] = slack_m[robot] * slack_m[robot];
    }
    for (const LaneSet::Group& group : set.groups()) {
      for (std::size_t share = 0; share < group.robots; ++share) {
        scratch.work.company[group.first_lane + share] = ((1u << group.robots) - 1) << group.first_lane;
      }
    }
    scratch.work.forget_rows();
    const kernel::Real start_x = lanes.position[0];
    const kernel::Real start_y = lanes.position[1];

    const unsigned all = (1u << robots.size()) - 1;
    for (std::size_t step = 0; step < steps; ++step) {
      const unsigned left = all & ~step_(*constants_, lanes, scratch.work, all);
      for (std::size_t g = 0; left != 0 && g < set.groups().size(); ++g) {
        const LaneSet::Group& group = set.groups()[g];
        if ((left & (1u << group.first_lane)) == 0) continue;
        GroupResult result = step_by_mujoco(group, set.robots(group), lanes, to);
        result.steps = step;
        if (result.end != GroupResult::End::done) return result;
      }
      const kernel::Real dx = lanes.position[0] - start_x;
      const kernel::Real dy = lanes.position[1] - start_y;
      const unsigned outside = all & kernel::lane_bits(dx * dx + dy * dy > slack_square);
      for (std::size_t lane = 0; outside != 0 && lane < robots.size(); ++lane) {
        if ((outside & (1u << lane)) != 0) {
          return {.end = GroupResult::End::left_disc,
                  .steps = step,
                  .robot = robots[lane],
                  .what = {},
                  .speed_m_s = std::hypot(lanes.velocity[0][lane], lanes.velocity[1][lane], lanes.velocity[2][lane])};
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

  /// One mj_step of the robots of a group; `to` holds their numbers on the way.
  [[nodiscard]] static GroupResult step_by_mujoco(const LaneSet::Group& group, std::span<const std::size_t> robots,
                                                  kernel::LaneState& lanes, RobotStates& to) {
    const EngineGuard guard;
    CompiledModel& compiled = *group.model;
    const CompiledModel::Turn turn{compiled};
    mjData& data = turn.data();
    for (std::size_t share = 0; share < robots.size(); ++share) {
      const std::size_t lane = group.first_lane + share;
      lanes.store(lane, to.numbers(robots[share]));
      to.load(robots[share], share, data);
      double* const targets = data.ctrl + share * compiled.layout().controls;
      for (std::size_t i = 0; i < lanes.target.size(); ++i) targets[i] = lanes.target[i][lane];
    }
    GroupResult result;
    try {
      mj_step(&compiled.model(), &data);
      result = read_warnings(compiled, data, robots);
    } catch (const EngineError& error) {
      result = {.end = GroupResult::End::diverged, .robot = robots.front(), .what = error.what()};
    }
    for (std::size_t share = 0; share < robots.size() && result.end == GroupResult::End::done; ++share) {
      if (!to.store(robots[share], share, data)) {
        result = {.end = GroupResult::End::diverged, .robot = robots[share], .what = "a number is NaN or too large"};
      }
    }
    if (result.end != GroupResult::End::done) {
      mj_resetData(&compiled.model(), &data);
      if (result.end == GroupResult::End::buffers_full) result.model = &compiled;
      return result;
    }
    for (std::size_t share = 0; share < robots.size(); ++share) {
      lanes.load(group.first_lane + share, to.numbers(robots[share]));
    }
    return {};
  }

  std::unique_ptr<const kernel::KernelModel> constants_;
  kernel::StepFunction step_ = kernel::fastest_step();
  std::vector<std::unique_ptr<Scratch>> scratch_;
};

}  // namespace trophic::backend::mujoco
