// SPDX-License-Identifier: MIT
// Four numbers in double precision side by side.
#pragma once

#include <cmath>
#include <cstddef>
#if defined(__SSE2__)
#include <emmintrin.h>
#endif

/// Every kernel function is inlined into its entry points, so that the same source is compiled once per instruction set.
#define TROPHIC_LANES_INLINE [[gnu::always_inline]] inline

// g++ notes at the end of the translation unit that functions returning lanes would be called differently with AVX; all
// are inlined, so none is called.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace trophic::backend::kernel {

inline constexpr std::size_t four = 4;

/// One double per robot, or three of a point and a fourth. Each lane is computed by the same IEEE operations in the same order
/// whatever the other lanes hold, so a robot's result does not depend on the other lanes nor on the instruction set.
using Four = double __attribute__((vector_size(four * sizeof(double)), aligned(four * sizeof(double))));
/// All bits of a lane are set where a comparison holds.
using FourMask = long long __attribute__((vector_size(four * sizeof(double)), aligned(four * sizeof(double))));

[[nodiscard]] TROPHIC_LANES_INLINE Four select(const FourMask& mask, const Four& yes, const Four& no) {
  return mask ? yes : no;
}

/// `value` where the mask holds, 0 elsewhere.
[[nodiscard]] TROPHIC_LANES_INLINE Four where(const FourMask& mask, const Four& value) {
  return (Four)((FourMask)value & mask);
}

[[nodiscard]] TROPHIC_LANES_INLINE Four abs(const Four& value) {
  return (Four)((FourMask)value & 0x7fff'ffff'ffff'ffffLL);
}

/// Bit i is set where lane i of the mask holds.
[[nodiscard]] TROPHIC_LANES_INLINE unsigned four_bits(const FourMask& mask) {
#if defined(__SSE2__)
  const Four bits = (Four)mask;
  return static_cast<unsigned>(_mm_movemask_pd(__builtin_shufflevector(bits, bits, 0, 1)) |
                               (_mm_movemask_pd(__builtin_shufflevector(bits, bits, 2, 3)) << 2));
#else
  unsigned bits = 0;
  for (std::size_t lane = 0; lane < four; ++lane) bits |= (mask[lane] != 0 ? 1u : 0u) << lane;
  return bits;
#endif
}

[[nodiscard]] TROPHIC_LANES_INLINE Four sqrt(const Four& value) {
#if defined(__SSE2__)
  const __m128d low = _mm_sqrt_pd(__builtin_shufflevector(value, value, 0, 1));
  const __m128d high = _mm_sqrt_pd(__builtin_shufflevector(value, value, 2, 3));
  return __builtin_shufflevector(low, high, 0, 1, 2, 3);
#else
  Four root{};
  for (std::size_t lane = 0; lane < four; ++lane) root[lane] = std::sqrt(value[lane]);
  return root;
#endif
}

}  // namespace trophic::backend::kernel
