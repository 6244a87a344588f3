// SPDX-License-Identifier: MIT
// Definitions of rng.hpp.
#pragma once

#include <trophic/support/rng.hpp>

// Philox needs no vector instructions; this saves Random123's include of 37,000 lines of intrinsics.
#ifndef R123_USE_SSE
#define R123_USE_SSE 0
#define R123_USE_X86INTRIN_H 0
#endif
#include <Random123/philox.h>

namespace trophic::detail {

TROPHIC_INLINE std::array<std::uint64_t, 4> philox(const std::array<std::uint64_t, 4>& counter,
                                                   const std::array<std::uint64_t, 2>& key) {
  const auto bits = r123::Philox4x64{}({{counter[0], counter[1], counter[2], counter[3]}}, {{key[0], key[1]}});
  return {bits[0], bits[1], bits[2], bits[3]};
}

}  // namespace trophic::detail
