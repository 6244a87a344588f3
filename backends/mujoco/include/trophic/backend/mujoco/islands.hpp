// SPDX-License-Identifier: MIT
// Steps robots that cannot touch separately, on several threads, with the motion of one big model.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <trophic/backend/clusters.hpp>
#include <trophic/backend/mujoco/give_back_pages.hpp>
#include <trophic/backend/mujoco/group_step.hpp>
#include <trophic/backend/mujoco/lane_step.hpp>
#include <trophic/support/thread_pool.hpp>
#include <utility>
#include <vector>

namespace trophic::backend::mujoco {

/// A robot lies within its bounding sphere and, during a block of steps, its centre stays within its slack of its start; every
/// step checks this. So robots with disjoint discs of (radius + slack) at the start of a block cannot touch within it, nor can
/// a robot touch the walls if its disc is clear of them. Connected discs make one group; a group is stepped in a cached model
/// of its size, with walls or without. If a robot leaves its disc, the block is repeated with twice the slack for it. The
/// result does not depend on the number of threads.
class Islands {
 public:
  /// `fast`: the kernel steps groups of up to four robots if it supports all features of the model.
  Islands(const RobotModel& robot, const Arena& arena, const Physics& physics, std::size_t threads, bool fast, BoxDepth box_depth)
      : robot_{robot}, arena_{arena}, physics_{physics}, box_depth_{box_depth}, pool_{std::make_unique<ThreadPool>(threads)} {
    if (!fast) return;
    constexpr ModelKey alone_with_walls = {1, true};
    auto model = make_model(alone_with_walls, 1);
    auto constants = kernel::read_model(model->model());
    if (!constants) return;
    lanes_.emplace(std::move(*constants), threads);
    models_[alone_with_walls].model = std::move(model);
  }

  [[nodiscard]] const Layout& layout() { return model_for({1, false}).layout(); }

  /// The number of calls of `advance` for which an unused model of a crowd is kept. MuJoCo's memory for a crowd's contacts is
  /// quadratic in its robots: 4 MB for ten, 26 MB for thirty.
  static constexpr std::uint64_t keeps_idle_models_for = 1000;

  [[nodiscard]] std::size_t models() const { return models_.size(); }  ///< currently cached
  /// The maximum number of working memories of the cached models.
  [[nodiscard]] std::size_t memories() const {
    std::size_t sum = 0;
    for (const auto& [key, kept] : models_) sum += kept.model->memories();
    return sum;
  }

  /// Takes all steps from the states in `from` to those in `to`; a result that is not `done` leaves `to` undefined.
  [[nodiscard]] GroupResult advance(const RobotStates& from, std::span<const double> targets_rad, std::size_t steps,
                                    RobotStates& to) {
    ++advances_;
    if (std::erase_if(models_, [&](const auto& entry) { return is_idle(entry.first, entry.second); }) > 0)
      give_back_freed_pages();
    slack_m_.resize(from.robots());
    for (std::size_t i = 0; i < from.robots(); ++i) slack_m_[i] = first_slack_m(from, i, steps);
    while (true) {
      GroupResult result = attempt(from, targets_rad, steps, to);
      if (result.end == GroupResult::End::done || result.end == GroupResult::End::diverged) return result;
    }
  }

 private:
  /// Number of robots in the model, and whether it has walls.
  using ModelKey = std::pair<std::size_t, bool>;

  /// Enough for a walking robot in one block, so that blocks are rarely repeated.
  static constexpr double least_slack_m = 0.02;

  [[nodiscard]] double first_slack_m(const RobotStates& states, std::size_t robot, std::size_t steps) const {
    const std::span<const double> velocity = states.velocities(robot);
    return least_slack_m + 1.5 * std::hypot(velocity[0], velocity[1]) * static_cast<double>(steps) * physics_.timestep_s;
  }

  struct KeptModel {
    std::unique_ptr<CompiledModel> model;
    std::uint64_t last_used = 0;  ///< the last call of `advance` that used it
  };

  /// Models of few robots are small, and the kernel refers to its own.
  [[nodiscard]] bool is_idle(const ModelKey& key, const KeptModel& kept) const {
    return key.first > kernel::lane_count && advances_ - kept.last_used > keeps_idle_models_for;
  }

  [[nodiscard]] std::unique_ptr<CompiledModel> make_model(const ModelKey& key, std::size_t memories) const {
    const auto collisions = key.first <= most_robots_with_pairs ? Collisions::pairs : Collisions::broadphase;
    const Scene scene{.walls = key.second, .collisions = collisions, .servos = Servos::combined, .box_depth = box_depth_};
    return std::make_unique<CompiledModel>(robot_, arena_, physics_, scene, key.first, memories);
  }

  CompiledModel& model_for(const ModelKey& key) {
    auto& [model, last_used] = models_[key];
    last_used = advances_;
    if (!model) model = make_model(key, by_kernel(key.first) ? 1 : pool_->threads());
    return *model;
  }

  /// Whether the kernel steps groups of this size. It leaves so few steps to MuJoCo that its threads share working memories:
  /// with one for each thread, each would be used at some time, and memory would grow over a long run.
  [[nodiscard]] bool by_kernel(std::size_t robots) const { return lanes_ && robots <= kernel::lane_count; }

  [[nodiscard]] bool near_wall(const Disc& disc) const {
    return !arena_.height_field && std::max(std::abs(disc.x_m), std::abs(disc.y_m)) + disc.radius_m >= arena_.half_side_m;
  }

  /// Steps every group once. Returns `done`, or the result to report or repair; repairs (slack, capacity) are already made.
  [[nodiscard]] GroupResult attempt(const RobotStates& states, std::span<const double> targets_rad, std::size_t steps,
                                    RobotStates& next) {
    discs_.clear();
    for (std::size_t i = 0; i < states.robots(); ++i) {
      const std::span<const double> root = states.positions(i);
      discs_.push_back({root[0], root[1], robot_.bounding_radius_m + slack_m_[i]});
    }
    std::vector<std::vector<std::size_t>> groups = connected_sets(discs_);
    const auto model_of = [&](const std::vector<std::size_t>& group) -> CompiledModel& {
      return model_for({group.size(), std::ranges::any_of(group, [&](std::size_t robot) { return near_wall(discs_[robot]); })});
    };
    const auto first_fitting = std::ranges::find_if(groups, [&](const auto& group) { return by_kernel(group.size()); });
    // Robots near walls share lanes, so that the other sets need not look for walls.
    const auto first_single = std::ranges::find_if(groups, [](const auto& group) { return group.size() == 1; });
    std::stable_partition(first_single, groups.end(), [&](const auto& group) { return near_wall(discs_[group.front()]); });
    const std::span large{groups.begin(), first_fitting};
    models_of_large_.clear();
    for (const std::vector<std::size_t>& group : large) models_of_large_.push_back(&model_of(group));
    fill_lanes({first_fitting, groups.end()}, model_of, lane_sets_);

    results_.assign(large.size() + lane_sets_.size(), {});
    pool_->run(results_.size(), [&](std::size_t i, std::size_t thread) {
      results_[i] = i < large.size()
                        ? step_group(*models_of_large_[i], large[i], targets_rad, slack_m_, steps, states, next)
                        : lanes_->advance(lane_sets_[i - large.size()], thread, targets_rad, slack_m_, steps, states, next);
    });
    return repair(fastest_m_s * static_cast<double>(steps) * physics_.timestep_s);
  }

  /// The most urgent result: a robot that is too fast, then results that can be repaired, then the earliest divergence.
  /// `farthest_m`: the largest allowed displacement.
  [[nodiscard]] GroupResult repair(double farthest_m) {
    GroupResult worst;
    const auto is_before = [](const GroupResult& a, const GroupResult& b) {
      return std::pair{a.steps, a.robot} < std::pair{b.steps, b.robot};
    };
    for (const GroupResult& result : results_) {
      if (!is_too_fast(result, farthest_m)) continue;
      if (worst.end == GroupResult::End::done || is_before(result, worst)) worst = result;
    }
    if (worst.end != GroupResult::End::done) {
      worst.end = GroupResult::End::diverged;
      worst.what = too_fast();
      return worst;
    }
    for (GroupResult& result : results_) {
      if (result.end == GroupResult::End::left_disc) {
        slack_m_[result.robot] *= 2.0;
      } else if (result.end == GroupResult::End::buffers_full && !result.model->grow()) {
        result.end = GroupResult::End::diverged;
      }
      if (result.end == GroupResult::End::done) continue;
      const bool both_diverged = result.end == GroupResult::End::diverged && worst.end == GroupResult::End::diverged;
      if (worst.end == GroupResult::End::done || result.end < worst.end || (both_diverged && is_before(result, worst))) {
        worst = std::move(result);
      }
    }
    return worst;
  }

  [[nodiscard]] bool is_too_fast(const GroupResult& result, double farthest_m) const {
    return result.end == GroupResult::End::left_disc && (result.speed_m_s > fastest_m_s || slack_m_[result.robot] > farthest_m);
  }

  /// Above this, MuJoCo's sweep over bodies is cheaper than testing every pair of boxes.
  static constexpr std::size_t most_robots_with_pairs = 1;

  RobotModel robot_;
  Arena arena_;
  Physics physics_;
  BoxDepth box_depth_;
  std::unique_ptr<ThreadPool> pool_;
  std::map<ModelKey, KeptModel> models_;
  std::uint64_t advances_ = 0;
  std::optional<LaneStepper> lanes_;
  std::vector<double> slack_m_;
  std::vector<Disc> discs_;
  std::vector<CompiledModel*> models_of_large_;
  std::vector<LaneSet> lane_sets_;
  std::vector<GroupResult> results_;
};

}  // namespace trophic::backend::mujoco
