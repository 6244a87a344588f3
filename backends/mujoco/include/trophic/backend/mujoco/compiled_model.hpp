// SPDX-License-Identifier: MIT
// A compiled MuJoCo model of robots, its working memories (one per thread), and the indices of a robot's numbers.
#pragma once

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <trophic/backend/mujoco/compile.hpp>
#include <trophic/backend/mujoco/mjcf.hpp>
#include <trophic/backend/mujoco/versions.hpp>
#include <vector>

namespace trophic::backend::mujoco {

/// The sizes of one robot's share of a model, and the indices of its hinge angles in its share of qpos.
struct Layout {
  std::size_t positions = 0;   ///< numbers in qpos
  std::size_t velocities = 0;  ///< numbers in qvel
  std::size_t controls = 0;    ///< numbers in ctrl, the hinges' targets first
  std::size_t hinges = 0;
  std::vector<std::size_t> angle_index;  ///< one per hinge, in the order of RobotModel::hinges
};

/// MuJoCo numbers a robot's joints link by link, each followed by all links beyond it.
[[nodiscard]] inline Layout layout_of(const RobotModel& robot, Servos servos) {
  const std::size_t hinges = robot.hinges.size();
  Layout layout{hinges + 7, hinges + 6, servos == Servos::combined ? hinges : 2 * hinges, hinges,
                std::vector<std::size_t>(hinges)};
  std::size_t next = 7;
  const auto number_beyond = [&](const auto& self, std::size_t parent) -> void {
    for (std::size_t link = parent + 1; link < robot.links.size(); ++link) {
      if (robot.links[link].parent != static_cast<int>(parent)) continue;
      layout.angle_index[link - 1] = next++;
      self(self, link);
    }
  };
  number_beyond(number_beyond, 0);
  return layout;
}

/// The first of a robot's numbers in each of MuJoCo's arrays.
struct Share {
  std::size_t position;
  std::size_t velocity;
  std::size_t control;
  std::size_t hinges;
};

/// Robots in one scene. Each has its share of qpos, qvel and ctrl, in the order in which they are listed.
class CompiledModel {
 public:
  /// `robots`: the body of each. `memories`: the number of threads that can step it at the same time.
  CompiledModel(std::span<const RobotModel* const> robots, const Arena& arena, const Physics& physics, const Scene& scene,
                std::size_t memories)
      : robots_{robots.size()}, data_(memories), taken_(memories, false) {
    const std::string height_file = "ground.hfield";
    // MuJoCo takes a step when it compiles a model: far enough apart and above the ground, robots touch nothing.
    std::vector<Pose> apart(robots.size());
    double ground_m = arena.height_field ? std::ranges::max(arena.height_field->height_m) : 0.0;
    for (const Obstacle& one : arena.obstacles) ground_m = std::max(ground_m, one.height_m);
    double widest_m = 0.0;
    for (const RobotModel* robot : robots) widest_m = std::max(widest_m, robot->bounding_radius_m);
    for (std::size_t i = 0; i < robots.size(); ++i) {
      apart[i].position_m = {3.0 * widest_m * static_cast<double>(i), 0.0, ground_m + 3.0 * widest_m};
    }
    std::optional<NamedFile> heights;
    if (arena.height_field) heights = {height_file, height_file_content(*arena.height_field)};
    model_ = compile(write_mjcf(robots, arena, physics, scene, apart, height_file), heights);
    // Dense rows are faster only for one or two robots.
    model_->opt.jacobian = robots.size() < 3 || !solves_sparse ? mjJAC_DENSE : mjJAC_SPARSE;
    layout_ = layout_of(*robots.front(), scene.servos);
    read_shares(robots, scene.servos);
    resize(std::min<std::size_t>(300 + 100 * robots.size(), largest_rows()));
  }
  /// Robots of one body.
  CompiledModel(const RobotModel& robot, const Arena& arena, const Physics& physics, const Scene& scene, std::size_t robots,
                std::size_t memories)
      : CompiledModel{std::vector<const RobotModel*>(robots, &robot), arena, physics, scene, memories} {}

  [[nodiscard]] std::size_t robots() const { return robots_; }
  [[nodiscard]] const mjModel& model() const { return *model_; }
  /// The first robot's layout.
  [[nodiscard]] const Layout& layout() const { return layout_; }
  [[nodiscard]] std::span<const Share> shares() const { return shares_; }
  /// The listed robot to which an index in MuJoCo's arrays belongs.
  [[nodiscard]] std::size_t owner(std::size_t Share::*begin, std::size_t index) const {
    const auto next = std::ranges::find_if(shares_, [&](const Share& share) { return share.*begin > index; });
    return static_cast<std::size_t>(std::max<std::ptrdiff_t>(next - shares_.begin(), 1) - 1);
  }

  /// One of the working memories, constructed at its first use, for exclusive use.
  [[nodiscard]] mjData& data(std::size_t slot) {
    if (!data_[slot]) {
      const EngineGuard guard;
      data_[slot].reset(mj_makeData(model_.get()));
      if (!data_[slot]) throw std::runtime_error{"MuJoCo: model of " + std::to_string(robots_) + " robots is too large"};
      give_back_dual_matrix(*model_, *data_[slot]);
    }
    return *data_[slot];
  }

  /// Lends a thread the first working memory that no other thread holds, waiting for one if necessary. A model that steps one
  /// group at a time needs only one memory, for any number of threads.
  class Turn {
   public:
    explicit Turn(CompiledModel& model) : model_{model} {
      std::unique_lock lock{model_.taking_};
      const auto first_free = [&] { return std::ranges::find(model_.taken_, false); };
      model_.freed_.wait(lock, [&] { return first_free() != model_.taken_.end(); });
      const auto free = first_free();
      *free = true;
      slot_ = static_cast<std::size_t>(free - model_.taken_.begin());
    }
    ~Turn() {
      {
        const std::lock_guard lock{model_.taking_};
        model_.taken_[slot_] = false;
      }
      model_.freed_.notify_one();
    }
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;

    [[nodiscard]] std::size_t slot() const { return slot_; }
    [[nodiscard]] mjData& data() const { return model_.data(slot_); }

   private:
    CompiledModel& model_;
    std::size_t slot_ = 0;
  };

  /// Doubles the capacity for contacts. Returns false if MuJoCo's 31-bit buffer size is reached.
  bool grow() {
    const auto rows = static_cast<std::size_t>(model_->njmax);
    const std::size_t larger = std::min(2 * rows, largest_rows());
    if (larger <= rows) return false;
    resize(larger);
    for (DataPtr& data : data_) data.reset();
    return true;
  }

 private:
  void read_shares(std::span<const RobotModel* const> robots, Servos servos) {
    Share next{};
    for (std::size_t i = 0; i < robots.size(); ++i) {
      const Layout layout = layout_of(*robots[i], servos);
      next.hinges = layout.hinges;
      shares_.push_back(next);
      for (std::size_t hinge = 0; hinge < layout.hinges; ++hinge) {
        const int joint = mj_name2id(model_.get(), mjOBJ_JOINT, hinge_name(i, hinge).c_str());
        const auto index = static_cast<std::size_t>(model_->jnt_qposadr[joint]);
        if (index != next.position + layout.angle_index[hinge]) throw std::logic_error{"MuJoCo ordered the joints differently"};
      }
      next.position += layout.positions;
      next.velocity += layout.velocities;
      next.control += layout.controls;
    }
  }

  /// Capacity for `rows` constraint rows, hence for rows / 4 contacts (a pyramid of four edges each). The stack has the size
  /// that the Newton solver and the collision sweep need, instead of the much larger default for other solvers.
  void resize(std::size_t rows) {
    const auto nv = static_cast<std::size_t>(model_->nv);
    const auto bodies = static_cast<std::size_t>(model_->nbody);
    set_capacity(*model_, rows, 50000 + 5 * nv * nv + bodies * bodies + 200 * (nv + bodies) + 20 * rows);
  }

  /// The largest number of rows for which mjData's buffer stays below 2^31 bytes: per row the Jacobian and its transpose with
  /// their column indices (12 bytes an entry each), and the square matrix of the dual solvers with its indices.
  [[nodiscard]] std::size_t largest_rows() const {
    const auto nv = static_cast<double>(model_->nv);
    const double fixed = 8.0 * nv * (static_cast<double>(model_->nu) + 200.0) + 0x1p24;
    const double per_row = 24.0 * nv + 200.0 + sizeof(mjContact) / 4.0;
    const double room = 0x1p31 - fixed;
    if (room <= 0.0) throw std::runtime_error{"MuJoCo: " + std::to_string(robots_) + " robots are too many for one model"};
    return static_cast<std::size_t>((-per_row + std::sqrt(per_row * per_row + 48.0 * room)) / 24.0);
  }

  std::size_t robots_;
  ModelPtr model_;
  Layout layout_;
  std::vector<Share> shares_;
  std::vector<DataPtr> data_;
  std::vector<bool> taken_;
  std::mutex taking_;
  std::condition_variable freed_;
};

}  // namespace trophic::backend::mujoco
