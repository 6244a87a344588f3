// SPDX-License-Identifier: MIT
// Steps crews of robots by the kernel, and by MuJoCo where the kernel declines.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <trophic/backend/mujoco/crews.hpp>
#include <trophic/backend/mujoco/group_step.hpp>
#include <trophic/backend/mujoco/kernel/step.hpp>
#include <trophic/backend/mujoco/kinds.hpp>
#include <utility>
#include <vector>

namespace trophic::backend::mujoco {

/// The kernel with the working memory of each thread.
class LaneStepper {
 public:
  /// Returns the model in which MuJoCo steps these robots; any thread may call it.
  using ModelOf = std::function<CompiledModel&(std::span<const std::size_t> robots)>;

  LaneStepper(BoxDepth box_depth, std::size_t threads) : box_depth_{box_depth}, scratch_(threads) {}

  /// Steps of robots that MuJoCo took because the kernel declined them.
  [[nodiscard]] std::uint64_t declined_robot_steps() const {
    std::uint64_t sum = 0;
    for (const auto& scratch : scratch_) sum += scratch ? scratch->robot_steps : 0;
    return sum;
  }

  /// Takes `steps` steps of the robots of a crew. Otherwise as `step_group`.
  [[nodiscard]] GroupResult advance(const CrewPlan& plan, const Kinds& kinds, std::size_t thread, const Rows& targets_rad,
                                    std::span<const double> slack_m, std::size_t steps, const RobotStates& from, RobotStates& to,
                                    const ModelOf& model_of) {
    Scratch& scratch = seat(plan, kinds, thread, targets_rad, slack_m, from);
    kernel::Crew& crew = scratch.crew;
    for (std::size_t step = 0; step < steps; ++step) {
      step_(crew);
      for (std::size_t t = 0; t < crew.team_count; ++t) {
        if (crew.teams[t]->going == crew.teams[t]->lanes) continue;
        GroupResult result = step_declined(plan, scratch, targets_rad, to, model_of);
        result.steps = step;
        if (result.end != GroupResult::End::done) return result;
        break;
      }
      for (std::size_t t = 0; t < crew.team_count; ++t) {
        const kernel::Team& team = *crew.teams[t];
        const Start& start = scratch.starts[t];
        const kernel::Real dx = team.state.position[0] - start.x;
        const kernel::Real dy = team.state.position[1] - start.y;
        const unsigned outside = team.lanes & kernel::lane_bits(dx * dx + dy * dy > start.slack_square);
        for (std::size_t lane = 0; outside != 0 && lane < kernel::lane_count; ++lane) {
          if ((outside & (1u << lane)) == 0) continue;
          const kernel::LaneArray& velocity = team.state.velocity;
          return {.end = GroupResult::End::left_disc,
                  .steps = step,
                  .robot = plan.robot({t, lane}),
                  .what = {},
                  .speed_m_s = std::hypot(velocity[0][lane], velocity[1][lane], velocity[2][lane])};
        }
      }
    }
    for (const kernel::Seat& seat : plan.order) {
      const std::size_t robot = plan.robot(seat);
      crew.team(seat).state.store(seat.lane, to.numbers(robot));
      if (!to.sound(robot)) {
        return {.end = GroupResult::End::diverged, .steps = steps, .robot = robot, .what = "a number is NaN or too large"};
      }
    }
    return {};
  }

 private:
  /// The starts of the robots of a team.
  struct Start {
    kernel::Real x;
    kernel::Real y;
    kernel::Real slack_square;
  };
  struct Scratch {
    explicit Scratch(BoxDepth box_depth) : crew{box_depth} {}
    kernel::Crew crew;
    std::vector<Start> starts;
    std::vector<kernel::Seat> declined;
    std::vector<std::size_t> robots;
    std::uint64_t robot_steps = 0;  ///< by MuJoCo
  };

  /// Puts the robots of a plan into their seats.
  Scratch& seat(const CrewPlan& plan, const Kinds& kinds, std::size_t thread, const Rows& targets_rad,
                std::span<const double> slack_m, const RobotStates& from) {
    const EngineGuard guard;
    if (!scratch_[thread]) scratch_[thread] = std::make_unique<Scratch>(box_depth_);
    Scratch& scratch = *scratch_[thread];
    kernel::Crew& crew = scratch.crew;
    crew.clear();
    scratch.starts.clear();
    for (const CrewPlan::Team& seats : plan.teams) {
      std::array<std::shared_ptr<const kernel::KernelModel>, kernel::lane_count> bodies;
      for (std::size_t lane = 0; lane < seats.used; ++lane) bodies[lane] = kinds[from.kind(seats.robots[lane])].constants;
      kernel::Team& team = crew.add_team({bodies.data(), seats.used});
      kernel::Real slack_square{};
      for (std::size_t lane = 0; lane < seats.used; ++lane) {
        const std::size_t robot = seats.robots[lane];
        team.state.load(team.model.body(lane), lane, from.numbers(robot), targets_rad[robot]);
        slack_square[lane] = slack_m[robot] * slack_m[robot];
      }
      team.lanes = (1u << seats.used) - 1;
      scratch.starts.push_back({team.state.position[0], team.state.position[1], slack_square});
    }
    crew.order = plan.order;
    crew.neighbours = plan.neighbours;
    return scratch;
  }

  /// One mj_step of all robots that are not `going`, those together that share a fate.
  [[nodiscard]] static GroupResult step_declined(const CrewPlan& plan, Scratch& scratch, const Rows& targets_rad, RobotStates& to,
                                                 const ModelOf& model_of) {
    kernel::Crew& crew = scratch.crew;
    for (const kernel::Seat& first : plan.order) {
      if (crew.team(first).is_going(first.lane)) continue;
      scratch.declined.clear();
      scratch.robots.clear();
      for (const kernel::Seat& seat : plan.order) {
        if (crew.ties.first(seat.slot()) != crew.ties.first(first.slot())) continue;
        scratch.declined.push_back(seat);
        scratch.robots.push_back(plan.robot(seat));
        ++scratch.robot_steps;
        crew.team(seat).going |= 1u << seat.lane;
      }
      GroupResult result = step_by_mujoco(model_of(scratch.robots), scratch, targets_rad, to);
      if (result.end != GroupResult::End::done) return result;
    }
    return {};
  }

  /// One mj_step of the robots in `scratch.declined`; `to` holds their numbers on the way.
  [[nodiscard]] static GroupResult step_by_mujoco(CompiledModel& compiled, Scratch& scratch, const Rows& targets_rad,
                                                  RobotStates& to) {
    const EngineGuard guard;
    const CompiledModel::Turn turn{compiled};
    mjData& data = turn.data();
    const std::vector<std::size_t>& robots = scratch.robots;
    const auto lanes_of = [&](std::size_t i) -> kernel::LaneState& { return scratch.crew.team(scratch.declined[i]).state; };
    for (std::size_t i = 0; i < robots.size(); ++i) {
      const Share& share = compiled.shares()[i];
      lanes_of(i).store(scratch.declined[i].lane, to.numbers(robots[i]));
      to.load(robots[i], share, data);
      std::ranges::copy(targets_rad[robots[i]], data.ctrl + share.control);
    }
    GroupResult result;
    try {
      mj_step(&compiled.model(), &data);
      result = read_warnings(compiled, data, robots);
    } catch (const EngineError& error) {
      result = read_error(error, robots);
    }
    for (std::size_t i = 0; i < robots.size() && result.end == GroupResult::End::done; ++i) {
      if (!to.store(robots[i], compiled.shares()[i], data)) {
        result = {.end = GroupResult::End::diverged, .robot = robots[i], .what = "a number is NaN or too large"};
      }
    }
    if (result.end != GroupResult::End::done) {
      mj_resetData(&compiled.model(), &data);
      if (result.end == GroupResult::End::buffers_full) result.model = &compiled;
      return result;
    }
    for (std::size_t i = 0; i < robots.size(); ++i) lanes_of(i).load(scratch.declined[i].lane, to.numbers(robots[i]));
    return {};
  }

  BoxDepth box_depth_;
  kernel::StepFunction step_ = kernel::fastest_step();
  std::vector<std::unique_ptr<Scratch>> scratch_;
};

}  // namespace trophic::backend::mujoco
