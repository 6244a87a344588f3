// SPDX-License-Identifier: MIT
// trophic::mujoco_compiled: the kernel for processors with AVX-512.
#include <trophic/backend/mujoco/kernel/step_avx512.ipp>
