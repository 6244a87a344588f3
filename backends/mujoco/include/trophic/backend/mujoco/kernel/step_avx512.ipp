// SPDX-License-Identifier: MIT
// The kernel for processors with AVX-512: 256-bit registers as with AVX2, but twice as many, and masks apart from them. Registers
// of 512 bits would hold twice as many robots, which then wait for the slowest. Compiled libraries only: it takes as long to
// compile as step_avx2.ipp, and results are the same.
#pragma once

#include <trophic/backend/mujoco/kernel/any_step.hpp>
#include <trophic/backend/mujoco/kernel/step.hpp>

#if defined(__x86_64__) && !defined(__AVX2__)
namespace trophic::backend::kernel::TROPHIC_LANES {

[[gnu::flatten, gnu::target("avx2,avx512f,avx512dq,avx512vl")]] TROPHIC_INLINE void step_avx512(Batch& batch) {
  any_step(batch);
}

}  // namespace trophic::backend::kernel::TROPHIC_LANES
#endif
