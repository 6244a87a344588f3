// SPDX-License-Identifier: MIT
// trophic::mujoco_compiled: the kernel for every processor.
#include <trophic/backend/mujoco/kernel/step_portable.ipp>
