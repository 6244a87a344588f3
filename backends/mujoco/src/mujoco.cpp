// SPDX-License-Identifier: MIT
// trophic::mujoco_compiled: all but the kernel.
#include <trophic/backend/mujoco.ipp>
#include <trophic/backend/mujoco/kernel/step.ipp>
