// SPDX-License-Identifier: MIT
// The kernel for every processor.
#pragma once

#include <trophic/backend/mujoco/kernel/any_step.hpp>
#include <trophic/backend/mujoco/kernel/step.hpp>

namespace trophic::backend::kernel {

[[gnu::flatten]] TROPHIC_INLINE unsigned step_portable(const KernelModel& model, LaneState& state, Workspace& work,
                                                       unsigned lanes) {
  return any_step(model, state, work, lanes);
}

}  // namespace trophic::backend::kernel
