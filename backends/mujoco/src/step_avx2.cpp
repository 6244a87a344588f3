// SPDX-License-Identifier: MIT
// trophic::mujoco_compiled: the kernel for processors with AVX2.
#include <trophic/backend/mujoco/kernel/step_avx2.ipp>
