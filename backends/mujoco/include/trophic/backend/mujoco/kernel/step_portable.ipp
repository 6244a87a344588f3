// SPDX-License-Identifier: MIT
// The kernel for every processor.
#pragma once

#include <trophic/backend/mujoco/kernel/any_step.hpp>
#include <trophic/backend/mujoco/kernel/step.hpp>

namespace trophic::backend::kernel::TROPHIC_LANES {

// Most processors use step_avx2. Header-only programs compile this one with less optimisation: fully optimised it takes
// longest of all functions to compile.
#if TROPHIC_HEADER_ONLY && defined(__x86_64__) && !defined(__AVX2__) && !defined(__clang__)
[[gnu::optimize(1)]]
#endif
[[gnu::flatten]] TROPHIC_INLINE void
step_portable(Batch& batch) {
  any_step(batch);
}

}  // namespace trophic::backend::kernel::TROPHIC_LANES
