// SPDX-License-Identifier: MIT
// The kernel's entry points: one source, built once for each instruction set.
#pragma once

#include <trophic/support/linkage.hpp>

namespace trophic::backend::kernel {

struct KernelModel;
struct LaneState;
struct Workspace;

/// Steps the robots in `lanes` (bit i: lane i) once and returns the lanes that it stepped; the others keep their state and are
/// MuJoCo's to step.
using StepFunction = unsigned (*)(const KernelModel&, LaneState&, Workspace&, unsigned lanes);

[[nodiscard]] unsigned step_portable(const KernelModel& model, LaneState& state, Workspace& work, unsigned lanes);
#if defined(__x86_64__)
/// The same operations on 256-bit registers; no fused multiply-add, so that the result is the same to the last bit (where
/// `step_portable` is compiled for a processor that has them: with -ffp-contract=off).
[[nodiscard]] [[gnu::target("avx2")]] unsigned step_avx2(const KernelModel& model, LaneState& state, Workspace& work,
                                                         unsigned lanes);
/// The same operations with the registers and masks of AVX-512. Programs that compile the kernel themselves do without it.
[[nodiscard]] [[gnu::target("avx2,avx512f,avx512dq,avx512vl")]] unsigned step_avx512(const KernelModel& model, LaneState& state,
                                                                                     Workspace& work, unsigned lanes);
#endif

/// The fastest that this processor has.
[[nodiscard]] StepFunction fastest_step();

}  // namespace trophic::backend::kernel

#if TROPHIC_HEADER_ONLY
#include <trophic/backend/mujoco/kernel/step.ipp>
#include <trophic/backend/mujoco/kernel/step_avx2.ipp>
#include <trophic/backend/mujoco/kernel/step_portable.ipp>
#endif
