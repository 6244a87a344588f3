// SPDX-License-Identifier: MIT
// trophic::mujoco_compiled: step_avx2.cpp in single precision.
#define TROPHIC_LANES in_single
#include <trophic/backend/mujoco/kernel/step_avx2.ipp>
