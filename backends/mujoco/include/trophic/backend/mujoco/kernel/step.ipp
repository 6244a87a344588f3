// SPDX-License-Identifier: MIT
// Definitions of step.hpp but the kernel itself.
#pragma once

#include <trophic/backend/mujoco/kernel/step.hpp>

namespace trophic::backend::kernel::TROPHIC_LANES {

TROPHIC_INLINE StepFunction fastest_step() {
#if defined(__x86_64__) && !defined(__AVX2__)
#if !TROPHIC_HEADER_ONLY && !defined(TROPHIC_FEW_KERNELS)
  if (__builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq")) return step_avx512;
#endif
  if (__builtin_cpu_supports("avx2")) return step_avx2;
#endif
  return step_portable;
}

}  // namespace trophic::backend::kernel::TROPHIC_LANES
