// SPDX-License-Identifier: MIT
// Steps batches of robots with the kernel, or with MuJoCo where the kernel declines.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <trophic/backend/mujoco/batches.hpp>
#include <trophic/backend/mujoco/kernel/step.hpp>
#include <trophic/backend/mujoco/lane_stepper.hpp>
#include <utility>
#include <vector>

namespace trophic::backend::mujoco::TROPHIC_LANES {

/// A LaneStepper with as many lanes as TROPHIC_LANES has.
class Lanes final : public LaneStepper {
 public:
  Lanes(BoxDepth box_depth, std::size_t threads, kernel::StepFunction step = kernel::fastest_step())
      : box_depth_{box_depth}, step_{step}, scratch_(threads), planner_{threads} {}

  [[nodiscard]] Counts counts() const override {
    Counts sum{};
    for (const auto& scratch : scratch_) {
      for (std::size_t i = 0; scratch && i < sum.size(); ++i) sum[i] += scratch->counts[i];
    }
    return sum;
  }

  [[nodiscard]] std::size_t plan(std::span<const std::vector<std::size_t>> groups, std::span<const std::size_t> lone,
                                 std::span<const Disc> discs, const Kinds& kinds, const RobotStates& states) override {
    plans_ = planner_.plan(
        groups, discs, [&](std::size_t robot) { return kinds[states.kind(robot)].shape; }, lone);
    return plans_.size();
  }

  [[nodiscard]] GroupResult advance(std::size_t batch_index, const Kinds& kinds, std::size_t thread, const Rows& targets_rad,
                                    std::span<const double> slack_m, std::size_t steps, const RobotStates& from, RobotStates& to,
                                    const ModelOf& model_of) override {
    const BatchPlan& plan = plans_[batch_index];
    Scratch& scratch = load(plan, kinds, thread, targets_rad, slack_m, from);
    kernel::Batch& batch = scratch.batch;
    for (std::size_t step = 0; step < steps; ++step) {
      step_(batch);
      scratch.counts[island_size(batch)] += batch.pack_count;
      for (std::size_t t = 0; t < batch.pack_count; ++t) {
        if (batch.packs[t]->valid == batch.packs[t]->lanes) continue;
        GroupResult result = step_declined(plan, scratch, targets_rad, to, model_of);
        result.steps = step;
        if (result.end != GroupResult::End::done) return result;
        break;
      }
      for (std::size_t t = 0; t < batch.pack_count; ++t) {
        const kernel::Pack& pack = *batch.packs[t];
        const Start& start = scratch.starts[t];
        const kernel::Real dx = pack.state.position[0] - start.x;
        const kernel::Real dy = pack.state.position[1] - start.y;
        const unsigned outside = pack.lanes & kernel::lane_bits(dx * dx + dy * dy > start.slack_square);
        for (std::size_t lane = 0; outside != 0 && lane < kernel::lane_count; ++lane) {
          if ((outside & (1u << lane)) == 0) continue;
          const kernel::LaneArray& velocity = pack.state.velocity;
          return {.end = GroupResult::End::left_disc,
                  .steps = step,
                  .robot = plan.robot({t, lane}),
                  .what = {},
                  .speed_m_s = std::hypot(velocity[0][lane], velocity[1][lane], velocity[2][lane])};
        }
      }
    }
    for (const kernel::LaneIndex& at : plan.order) {
      const std::size_t robot = plan.robot(at);
      batch.pack(at).state.store(at.lane, to.numbers(robot));
      if (std::string fault = to.fault(robot); !fault.empty()) {
        return {.end = GroupResult::End::diverged, .steps = steps, .robot = robot, .what = std::move(fault)};
      }
    }
    return {};
  }

 private:
  struct Start {
    kernel::Real x;
    kernel::Real y;
    kernel::Real slack_square;
  };
  struct Scratch {
    explicit Scratch(BoxDepth box_depth) : batch{box_depth} {}
    kernel::Batch batch;
    std::vector<Start> starts;
    std::vector<kernel::LaneIndex> declined;
    std::vector<std::size_t> robots;
    Counts counts{};
  };

  /// The robots in the largest island of the last step, at most 3.
  [[nodiscard]] static std::size_t island_size(const kernel::Batch& batch) {
    std::size_t size = 0;
    const auto is_coupled = [](const auto& pack) { return pack->coupled != 0; };
    if (std::ranges::none_of(std::span{batch.packs}.first(batch.pack_count), is_coupled)) return size;
    for (std::size_t k = 0; k < batch.island_count; ++k) size = std::max(size, batch.islands[k].lanes.size());
    return std::min<std::size_t>(size, 3);
  }

  Scratch& load(const BatchPlan& plan, const Kinds& kinds, std::size_t thread, const Rows& targets_rad,
                std::span<const double> slack_m, const RobotStates& from) {
    const EngineGuard guard;
    if (!scratch_[thread]) scratch_[thread] = std::make_unique<Scratch>(box_depth_);
    Scratch& scratch = *scratch_[thread];
    kernel::Batch& batch = scratch.batch;
    batch.clear();
    scratch.starts.clear();
    for (const BatchPlan::Pack& planned : plan.packs) {
      std::array<std::shared_ptr<const kernel::KernelModel>, kernel::lane_count> bodies;
      for (std::size_t lane = 0; lane < planned.used; ++lane) bodies[lane] = kinds[from.kind(planned.robots[lane])].constants;
      kernel::Pack& pack = batch.add_pack({bodies.data(), planned.used});
      kernel::Real slack_square{};
      for (std::size_t lane = 0; lane < planned.used; ++lane) {
        const std::size_t robot = planned.robots[lane];
        pack.state.load(pack.model.body(lane), lane, from.numbers(robot), targets_rad[robot]);
        slack_square[lane] = slack_m[robot] * slack_m[robot];
      }
      pack.lanes = (1u << planned.used) - 1;
      scratch.starts.push_back({pack.state.position[0], pack.state.position[1], slack_square});
    }
    batch.order = plan.order;
    batch.neighbours = plan.neighbours;
    return scratch;
  }

  /// One mj_step of all robots that are not `valid`, those of one step set together; `to` holds their numbers in between.
  [[nodiscard]] static GroupResult step_declined(const BatchPlan& plan, Scratch& scratch, const Rows& targets_rad,
                                                 RobotStates& to, const ModelOf& model_of) {
    kernel::Batch& batch = scratch.batch;
    for (const kernel::LaneIndex& first : plan.order) {
      if (batch.pack(first).is_valid(first.lane)) continue;
      scratch.declined.clear();
      scratch.robots.clear();
      for (const kernel::LaneIndex& at : plan.order) {
        if (batch.step_sets.find(at.slot()) != batch.step_sets.find(first.slot())) continue;
        scratch.declined.push_back(at);
        scratch.robots.push_back(plan.robot(at));
        ++scratch.counts.back();
        batch.pack(at).valid |= 1u << at.lane;
        batch.pack(at).state.store(at.lane, to.numbers(plan.robot(at)));
      }
      GroupResult result = step_group(model_of(scratch.robots), scratch.robots, targets_rad, {}, 1, to, to);
      if (result.end != GroupResult::End::done) return result;
      for (const kernel::LaneIndex& at : scratch.declined) batch.pack(at).state.load(at.lane, to.numbers(plan.robot(at)));
    }
    return {};
  }

  BoxDepth box_depth_;
  kernel::StepFunction step_;
  std::vector<std::unique_ptr<Scratch>> scratch_;
  BatchPlanner planner_;
  std::span<const BatchPlan> plans_;
};

}  // namespace trophic::backend::mujoco::TROPHIC_LANES
