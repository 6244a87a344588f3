// SPDX-License-Identifier: MIT
// Steps robots with the kernel, in double or single precision.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <trophic/backend/clusters.hpp>
#include <trophic/backend/mujoco/group_step.hpp>
#include <trophic/backend/mujoco/kinds.hpp>
#include <vector>

namespace trophic::backend::mujoco {

/// The kernel with the working memory of each thread.
class LaneStepper {
 public:
  /// Returns the model in which MuJoCo steps these robots; any thread may call it.
  using ModelOf = std::function<CompiledModel&(std::span<const std::size_t> robots)>;
  /// Numbers of steps so far: of packs, by the number of robots in the largest island of their batch (none, one, two, more), then
  /// of robots that MuJoCo stepped because the kernel declined them.
  using Counts = std::array<std::uint64_t, 5>;

  LaneStepper() = default;
  LaneStepper(const LaneStepper&) = delete;
  LaneStepper& operator=(const LaneStepper&) = delete;
  virtual ~LaneStepper() = default;

  [[nodiscard]] virtual Counts counts() const = 0;

  /// Divides robots into batches (BatchPlanner) and returns their number.
  [[nodiscard]] virtual std::size_t plan(std::span<const std::vector<std::size_t>> groups, std::span<const std::size_t> lone,
                                         std::span<const Disc> discs, const Kinds& kinds, const RobotStates& states) = 0;

  /// Takes `steps` steps of the robots of a batch. Otherwise as `step_group`.
  [[nodiscard]] virtual GroupResult advance(std::size_t batch, const Kinds& kinds, std::size_t thread, const Rows& targets_rad,
                                            std::span<const double> slack_m, std::size_t steps, const RobotStates& from,
                                            RobotStates& to, const ModelOf& model_of) = 0;
};

/// The kernel in single precision. Throws std::invalid_argument in header-only programs and without TROPHIC_ALL_KERNELS.
[[nodiscard]] std::unique_ptr<LaneStepper> lanes_in_single(BoxDepth box_depth, std::size_t threads);

}  // namespace trophic::backend::mujoco
