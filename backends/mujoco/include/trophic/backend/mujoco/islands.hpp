// SPDX-License-Identifier: MIT
// Steps robots that cannot touch separately, on several threads, with the same motion as in one big model.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <trophic/backend/clusters.hpp>
#include <trophic/backend/mujoco/give_back_pages.hpp>
#include <trophic/backend/mujoco/kernel/model.hpp>
#include <trophic/backend/mujoco/lane_stepper.hpp>
#include <trophic/support/thread_pool.hpp>
#include <utility>
#include <vector>

namespace trophic::backend::mujoco {

/// A robot lies within its bounding sphere and, during a block of steps, its centre stays within its slack of its start; every
/// step checks this. So robots with disjoint discs of (radius + slack) at the start of a block cannot touch within it, nor can
/// a robot touch walls or obstacles if its disc is clear of them. Connected discs make one group, which is stepped by the kernel,
/// or in a cached model of its bodies, with walls and obstacles or without; the kernel has no obstacles. If a robot leaves its
/// disc, the block is repeated with twice the slack for it. The result does not depend on the number of threads.
class Islands {
 public:
  /// `lanes`: the kernel, which steps robots if it supports all features of their models; if empty, MuJoCo steps all.
  Islands(const RobotModel& robot, const Arena& arena, const Physics& physics, std::size_t threads, BoxDepth box_depth,
          std::unique_ptr<LaneStepper> lanes = nullptr)
      : arena_{arena},
        physics_{physics},
        box_depth_{box_depth},
        pool_{std::make_unique<ThreadPool>(threads)},
        lanes_{std::move(lanes)} {
    static_cast<void>(find_kind(robot));
  }

  /// The layout of the body that all robots have initially.
  [[nodiscard]] Layout layout() const { return layout_of(kinds_[0].robot, Servos::combined); }

  /// The kind of robots with this body, for `RobotStates::set_body`.
  [[nodiscard]] std::size_t set_body(std::size_t, const RobotModel& robot) { return find_kind(robot); }

  /// The number of calls of `advance` for which an unused kind of bodies or model of several robots is kept. MuJoCo's memory for
  /// a crowd's contacts is quadratic in its robots: 4 MB for ten, 26 MB for thirty.
  static constexpr std::uint64_t keeps_idle_models_for = 1000;

  /// The share of all steps of robots that MuJoCo computed, including repeated ones.
  [[nodiscard]] double engine_share() const {
    const std::uint64_t by_engine = group_robot_steps_ + (lanes_ ? lanes_->counts().back() : 0);
    return robot_steps_ == 0 ? 0.0 : static_cast<double>(by_engine) / static_cast<double>(robot_steps_);
  }
  [[nodiscard]] LaneStepper::Counts counts() const { return lanes_ ? lanes_->counts() : LaneStepper::Counts{}; }
  [[nodiscard]] std::size_t kinds() const { return kinds_.count(); }   ///< number of kinds that robots have or recently had
  [[nodiscard]] std::size_t models() const { return models_.size(); }  ///< currently cached

  /// Takes all steps from the states in `from` to those in `to`; a result that is not `done` leaves `to` undefined.
  [[nodiscard]] GroupResult advance(const RobotStates& from, const Rows& targets_rad, std::size_t steps, RobotStates& to) {
    ++advances_;
    for (std::size_t i = 0; i < from.robots(); ++i) kinds_.use(from.kind(i), advances_);
    drop_idle();
    slack_m_.resize(from.robots());
    for (std::size_t i = 0; i < from.robots(); ++i) slack_m_[i] = first_slack_m(from, i, steps);
    while (true) {
      GroupResult result = attempt(from, targets_rad, steps, to);
      if (result.end == GroupResult::End::done || result.end == GroupResult::End::diverged) return result;
    }
  }

 private:
  /// The kinds of the robots in the model, and whether it has walls and obstacles.
  using ModelKey = std::pair<std::vector<std::size_t>, bool>;

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

  [[nodiscard]] std::size_t find_kind(const RobotModel& robot) {
    return kinds_.find(robot, advances_, [&](const RobotModel& body) { return make_kind(body); });
  }

  /// The model from which a kind's constants are read is kept if it is the first kind, the only one in most runs.
  [[nodiscard]] std::unique_ptr<Kind> make_kind(const RobotModel& robot) {
    auto kind = std::make_unique<Kind>();
    kind->robot = robot;
    if (!lanes_) return kind;
    const RobotModel* body = &kind->robot;
    auto model = make_model({&body, 1}, {.walls = true, .obstacles = false}, 1);
    auto constants = kernel::read_model(model->model());
    if (constants) kind->constants = std::make_shared<const kernel::KernelModel>(std::move(*constants));
    if (models_.empty() && constants && arena_.obstacles.empty()) models_[{{0}, true}].model = std::move(model);
    return kind;
  }

  /// If all robots have the same body, the models of a few robots are reused often.
  [[nodiscard]] bool is_idle(const ModelKey& key, const KeptModel& kept) const {
    const bool has_unknown = !std::ranges::all_of(key.first, [&](std::size_t kind) { return kinds_.is_known(kind); });
    const bool is_kept = key.first.size() <= kept_robots && kinds_.count() == 1;
    return has_unknown || (!is_kept && advances_ - kept.last_used > keeps_idle_models_for);
  }

  void drop_idle() {
    if (advances_ > keeps_idle_models_for) kinds_.drop_before(advances_ - keeps_idle_models_for);
    if (std::erase_if(models_, [&](const auto& entry) { return is_idle(entry.first, entry.second); }) > 0)
      give_back_freed_pages();
  }

  [[nodiscard]] std::unique_ptr<CompiledModel> make_model(std::span<const RobotModel* const> robots, Scene scene,
                                                          std::size_t memories) const {
    // For several robots, MuJoCo's sweep over bodies is cheaper than testing every pair of boxes.
    scene.collisions = robots.size() == 1 ? Collisions::pairs : Collisions::broadphase;
    scene.servos = Servos::combined;
    scene.box_depth = box_depth_;
    return std::make_unique<CompiledModel>(robots, arena_, physics_, scene, memories);
  }

  /// The model of these robots. Any thread may call it. With the kernel, so few steps are left to MuJoCo that its threads share a
  /// working memory: with one per thread, each would be used at some time, and memory would grow over a long run.
  CompiledModel& model_of(std::span<const std::size_t> robots, const RobotStates& states) {
    ModelKey key{{}, std::ranges::any_of(robots, [&](std::size_t robot) {
                   return near_wall(discs_[robot]) || near_obstacle(discs_[robot]);
                 })};
    for (const std::size_t robot : robots) key.first.push_back(states.kind(robot));
    const std::lock_guard lock{finding_model_};
    auto& [model, last_used] = models_[key];
    last_used = advances_;
    if (!model) {
      std::vector<const RobotModel*> bodies;
      for (const std::size_t kind : key.first) bodies.push_back(&kinds_[kind].robot);
      const bool by_kernel = std::ranges::all_of(key.first, [&](std::size_t kind) { return kinds_[kind].constants != nullptr; });
      model = make_model(bodies, {.walls = key.second, .obstacles = key.second},
                         by_kernel && arena_.obstacles.empty() ? 1 : pool_->threads());
    }
    return *model;
  }

  [[nodiscard]] bool near_wall(const Disc& disc) const {
    return !arena_.height_field && std::max(std::abs(disc.x_m), std::abs(disc.y_m)) + disc.radius_m >= arena_.half_side_m;
  }

  [[nodiscard]] bool near_obstacle(const Disc& disc) const {
    return !is_clear(arena_, {.x_m = disc.x_m, .y_m = disc.y_m}, disc.radius_m);
  }

  /// Steps every group once. Returns `done`, or the result to report or repair; repairs (slack, capacity) are already made.
  [[nodiscard]] GroupResult attempt(const RobotStates& states, const Rows& targets_rad, std::size_t steps, RobotStates& next) {
    discs_.clear();
    for (std::size_t i = 0; i < states.robots(); ++i) {
      const std::span<const double> root = states.positions(i);
      const double radius_m = kinds_[states.kind(i)].robot.bounding_radius_m + slack_m_[i];
      discs_.push_back({root[0], root[1], states.is_there(i) ? radius_m : -1.0});
    }
    lone_.clear();
    std::vector<std::vector<std::size_t>> groups = connected_sets(discs_, &lone_);
    robot_steps_ += lone_.size() * steps;
    for (const std::vector<std::size_t>& group : groups) robot_steps_ += group.size() * steps;
    const auto is_mujocos = [&](std::size_t robot) {
      return kinds_[states.kind(robot)].constants == nullptr || near_obstacle(discs_[robot]);
    };
    const auto first_of_kernel = std::stable_partition(groups.begin(), groups.end(),
                                                       [&](const auto& group) { return std::ranges::any_of(group, is_mujocos); });
    std::vector<std::vector<std::size_t>> by_mujoco{groups.begin(), first_of_kernel};
    const auto first_lone = std::stable_partition(lone_.begin(), lone_.end(), is_mujocos);
    for (auto robot = lone_.begin(); robot != first_lone; ++robot) by_mujoco.push_back({*robot});
    // Robots near walls share lanes, so that the other packs need not check for walls.
    std::stable_partition(first_lone, lone_.end(), [&](std::size_t robot) { return near_wall(discs_[robot]); });
    models_of_groups_.clear();
    for (const std::vector<std::size_t>& group : by_mujoco) models_of_groups_.push_back(&model_of(group, states));
    const std::size_t batches =
        lanes_ ? lanes_->plan({first_of_kernel, groups.end()}, {first_lone, lone_.end()}, discs_, kinds_, states) : 0;
    const LaneStepper::ModelOf model_of_declined = [&](std::span<const std::size_t> robots) -> CompiledModel& {
      return model_of(robots, states);
    };

    for (const std::vector<std::size_t>& group : by_mujoco) group_robot_steps_ += group.size() * steps;
    results_.assign(by_mujoco.size() + batches, {});
    pool_->run(results_.size(), [&](std::size_t i, std::size_t thread) {
      results_[i] = i < by_mujoco.size()
                        ? step_group(*models_of_groups_[i], by_mujoco[i], targets_rad, slack_m_, steps, states, next)
                        : lanes_->advance(i - by_mujoco.size(), kinds_, thread, targets_rad, slack_m_, steps, states, next,
                                          model_of_declined);
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

  /// Models of up to this many robots are kept even if they are unused.
  static constexpr std::size_t kept_robots = 4;

  Arena arena_;
  Physics physics_;
  BoxDepth box_depth_;
  std::unique_ptr<ThreadPool> pool_;
  Kinds kinds_;
  std::map<ModelKey, KeptModel> models_;
  std::mutex finding_model_;
  std::uint64_t advances_ = 0;
  std::uint64_t robot_steps_ = 0;
  std::uint64_t group_robot_steps_ = 0;  ///< those of groups that MuJoCo steps as a whole
  std::unique_ptr<LaneStepper> lanes_;
  std::vector<double> slack_m_;
  std::vector<Disc> discs_;
  std::vector<std::size_t> lone_;
  std::vector<CompiledModel*> models_of_groups_;
  std::vector<GroupResult> results_;
};

}  // namespace trophic::backend::mujoco
