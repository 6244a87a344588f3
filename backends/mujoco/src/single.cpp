// SPDX-License-Identifier: MIT
// trophic::mujoco_compiled: the kernel in single precision, for every processor.
#define TROPHIC_LANES in_single
#include <trophic/backend/mujoco/kernel/step.ipp>
#include <trophic/backend/mujoco/kernel/step_portable.ipp>
#include <trophic/backend/mujoco/lane_step.hpp>

namespace trophic::backend::mujoco {

std::unique_ptr<LaneStepper> lanes_in_single(BoxDepth box_depth, std::size_t threads) {
  return std::make_unique<Lanes>(box_depth, threads);
}

}  // namespace trophic::backend::mujoco
