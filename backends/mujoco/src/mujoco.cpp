// SPDX-License-Identifier: MIT
// trophic::mujoco_compiled except the kernel.
#include <trophic/backend/mujoco.ipp>
#include <trophic/backend/mujoco/kernel/step.ipp>
