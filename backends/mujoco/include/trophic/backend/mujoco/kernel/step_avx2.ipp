// SPDX-License-Identifier: MIT
// The kernel for processors with AVX2; not in a file that is compiled for them alone, where the portable one is the same. The
// attribute, unlike a compiler flag for the whole file, keeps every other function that the file emits fit for all processors.
#pragma once

#include <trophic/backend/mujoco/kernel/any_step.hpp>
#include <trophic/backend/mujoco/kernel/step.hpp>

#if defined(__x86_64__) && !defined(__AVX2__)
namespace trophic::backend::kernel::TROPHIC_LANES {

[[gnu::flatten, gnu::target("avx2")]] TROPHIC_INLINE void step_avx2(Batch& batch) {
  any_step(batch);
}

}  // namespace trophic::backend::kernel::TROPHIC_LANES
#endif
