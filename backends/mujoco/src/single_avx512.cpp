// SPDX-License-Identifier: MIT
// trophic::mujoco_compiled: step_avx512.cpp in single precision.
#define TROPHIC_LANES in_single
#include <trophic/backend/mujoco/kernel/step_avx512.ipp>
