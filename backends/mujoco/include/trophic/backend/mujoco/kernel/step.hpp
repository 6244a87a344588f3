// SPDX-License-Identifier: MIT
// The kernel's entry points: one source, built once for each instruction set.
#pragma once

#include <trophic/backend/mujoco/kernel/lanes.hpp>
#include <trophic/support/linkage.hpp>

namespace trophic::backend::kernel::TROPHIC_LANES {

struct Batch;

/// Steps all robots of a batch once; afterwards those that it stepped are `valid`. The others keep their state and must be
/// stepped by MuJoCo.
using StepFunction = void (*)(Batch&);

void step_portable(Batch& batch);
#if defined(__x86_64__)
/// The same operations on 256-bit registers; no fused multiply-add, so that the result is the same to the last bit (where
/// `step_portable` is compiled for a processor that has them: with -ffp-contract=off).
[[gnu::target("avx2")]] void step_avx2(Batch& batch);
/// The same operations with the registers and masks of AVX-512. Programs that compile the kernel themselves do without it.
[[gnu::target("avx2,avx512f,avx512dq,avx512vl")]] void step_avx512(Batch& batch);
#endif

/// The fastest one that this processor supports.
[[nodiscard]] StepFunction fastest_step();

}  // namespace trophic::backend::kernel::TROPHIC_LANES

#if TROPHIC_HEADER_ONLY
#include <trophic/backend/mujoco/kernel/step.ipp>
#include <trophic/backend/mujoco/kernel/step_avx2.ipp>
#include <trophic/backend/mujoco/kernel/step_portable.ipp>
#endif
