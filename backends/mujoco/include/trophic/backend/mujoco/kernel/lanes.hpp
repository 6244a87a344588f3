// SPDX-License-Identifier: MIT
// Four numbers side by side, one per robot: the arithmetic type of the robot kernel.
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>
#if defined(__SSE2__)
#include <emmintrin.h>
#endif

/// Every kernel function is inlined into its entry points, so that the same source is compiled once per instruction set.
#define TROPHIC_LANES_INLINE [[gnu::always_inline]] inline

// g++ notes at the end of the translation unit that functions returning lanes would be called differently with AVX; they are
// all inlined, so there is no call.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace trophic::backend::kernel {

/// Robots stepped together.
inline constexpr std::size_t lane_count = 4;

/// One double per robot. Each lane is computed by the same IEEE operations in the same order whatever the other lanes hold, so a
/// robot's result does not depend on the other lanes nor on the instruction set.
using Real = double __attribute__((vector_size(lane_count * sizeof(double)), aligned(lane_count * sizeof(double))));
/// All bits of a lane are set where a comparison holds.
using Mask = long long __attribute__((vector_size(lane_count * sizeof(double)), aligned(lane_count * sizeof(double))));

[[nodiscard]] TROPHIC_LANES_INLINE Real broadcast(double value) {
  return Real{} + value;
}

[[nodiscard]] TROPHIC_LANES_INLINE Real select(const Mask& mask, const Real& yes, const Real& no) {
  return mask ? yes : no;
}

/// `value` where the mask holds, 0 elsewhere.
[[nodiscard]] TROPHIC_LANES_INLINE Real where(const Mask& mask, const Real& value) {
  return (Real)((Mask)value & mask);
}

[[nodiscard]] TROPHIC_LANES_INLINE Real abs(const Real& value) {
  return (Real)((Mask)value & 0x7fff'ffff'ffff'ffffLL);
}

/// Bit i is set where lane i of the mask holds.
[[nodiscard]] TROPHIC_LANES_INLINE unsigned lane_bits(const Mask& mask) {
#if defined(__SSE2__)
  const Real bits = (Real)mask;
  return static_cast<unsigned>(_mm_movemask_pd(__builtin_shufflevector(bits, bits, 0, 1)) |
                               (_mm_movemask_pd(__builtin_shufflevector(bits, bits, 2, 3)) << 2));
#else
  unsigned bits = 0;
  for (std::size_t lane = 0; lane < lane_count; ++lane) bits |= (mask[lane] != 0 ? 1u : 0u) << lane;
  return bits;
#endif
}

/// Bits of all lanes.
inline constexpr unsigned all_lanes = (1u << lane_count) - 1;

/// Bit i set: lane i of a mask is all ones.
[[nodiscard]] TROPHIC_LANES_INLINE Mask mask_of(unsigned lanes) {
  constexpr Mask bits = {1, 2, 4, 8};
  const Mask all = Mask{} + static_cast<long long>(lanes);
  return (all & bits) != 0;
}

[[nodiscard]] TROPHIC_LANES_INLINE Real sqrt(const Real& value) {
#if defined(__SSE2__)
  const __m128d low = _mm_sqrt_pd(__builtin_shufflevector(value, value, 0, 1));
  const __m128d high = _mm_sqrt_pd(__builtin_shufflevector(value, value, 2, 3));
  return __builtin_shufflevector(low, high, 0, 1, 2, 3);
#else
  Real root{};
  for (std::size_t lane = 0; lane < lane_count; ++lane) root[lane] = std::sqrt(value[lane]);
  return root;
#endif
}

/// Largest |angle| that `sine_cosine` is made for, rad; beyond it its error grows above one unit in the last place.
inline constexpr double largest_angle_rad = 1e4;

/// Sine and cosine: reduction to |r| <= pi/4 by multiples of pi/2 in three parts (Cody and Waite), Taylor series up to r^17 and
/// r^16, whose first omitted terms are below 1e-18.
TROPHIC_LANES_INLINE void sine_cosine(const Real& angle_rad, Real& sine, Real& cosine) {
  constexpr double rounding = 0x1.8p52;  // adding it leaves the nearest integer in the low bits of the mantissa
  const Real shifted = angle_rad * (2.0 / std::numbers::pi) + rounding;
  const Mask quadrant = (Mask)shifted;
  const Real turns = shifted - rounding;
  // pi/2 = sum of three parts; the products of the first two with |turns| < 2^20 are exact.
  constexpr double part_1 = 0x1.921fb544p+0;
  constexpr double part_2 = 0x1.0b4611a6p-34;
  constexpr double part_3 = 0x1.3198a2e037073p-69;
  const Real r = ((angle_rad - turns * part_1) - turns * part_2) - turns * part_3;
  const Real x = r * r;
  const Real odd =
      r + r * x *
              (-1.0 / 6 +
               x * (1.0 / 120 +
                    x * (-1.0 / 5040 + x * (1.0 / 362880 + x * (-1.0 / 39916800 +
                                                                x * (1.0 / 6227020800 + x * (-1.0 / 1307674368000 +
                                                                                             x * (1.0 / 355687428096000))))))));
  const Real even =
      1.0 -
      x * (0.5 - x * (1.0 / 24 -
                      x * (1.0 / 720 -
                           x * (1.0 / 40320 - x * (1.0 / 3628800 - x * (1.0 / 479001600 - x * (1.0 / 87178291200 -
                                                                                               x * (1.0 / 20922789888000))))))));
  const Mask swapped = (quadrant & 1) != 0;
  const Mask sine_sign = (quadrant & 2) << 62;
  const Mask cosine_sign = ((quadrant + 1) & 2) << 62;
  sine = (Real)((Mask)select(swapped, even, odd) ^ sine_sign);
  cosine = (Real)((Mask)select(swapped, odd, even) ^ cosine_sign);
}

/// A sequence of lanes on the heap, aligned for every instruction set.
class LaneArray {
 public:
  explicit LaneArray(std::size_t size = 0) : cells_(size) {}
  void resize(std::size_t size) { cells_.resize(size); }
  [[nodiscard]] TROPHIC_LANES_INLINE std::size_t size() const { return cells_.size(); }
  [[nodiscard]] TROPHIC_LANES_INLINE Real& operator[](std::size_t i) { return cells_[i].value; }
  [[nodiscard]] TROPHIC_LANES_INLINE const Real& operator[](std::size_t i) const { return cells_[i].value; }

 private:
  struct Cell {
    Real value{};
  };
  static_assert(sizeof(Cell) == sizeof(Real) && alignof(Cell) == sizeof(Real));
  std::vector<Cell> cells_;
};

}  // namespace trophic::backend::kernel
