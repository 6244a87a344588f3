// SPDX-License-Identifier: MIT
// Numbers side by side, one per robot: the arithmetic type of the robot kernel, in double or in single precision.
#pragma once

#include <numbers>
#include <trophic/backend/mujoco/kernel/four.hpp>
#include <vector>

/// Every source of the kernel is compiled in two namespaces: in_double, and in_single, which only `src/single.cpp` selects.
#ifdef TROPHIC_LANES
#include <trophic/backend/mujoco/kernel/single_lanes.hpp>
#else
#define TROPHIC_LANES in_double

namespace trophic::backend::kernel::in_double {

/// Robots stepped together.
inline constexpr std::size_t lane_count = four;

/// One number per robot. Each lane is computed by the same IEEE operations in the same order whatever the other lanes hold, so a
/// robot's result does not depend on the other lanes nor on the instruction set.
using Real = Four;
using Mask = FourMask;
using kernel::select;  // which that of vectors would hide

/// Largest |angle| in radians for `sine_cosine`, beyond which its error exceeds one unit in the last place.
inline constexpr double largest_angle_rad = 1e4;
/// Adding it leaves the nearest integer in the low bits of the mantissa.
inline constexpr double to_nearest = 0x1.8p52;
/// pi/2 = sum of three parts; the products of the first two with up to 2^20 are exact.
inline constexpr double right_angle[3] = {0x1.921fb544p+0, 0x1.0b4611a6p-34, 0x1.3198a2e037073p-69};
inline constexpr int sign_bit = 63;

[[nodiscard]] TROPHIC_LANES_INLINE Real broadcast(double value) {
  return Real{} + value;
}
[[nodiscard]] TROPHIC_LANES_INLINE Mask mask_from(const Real& bits) {
  return (Mask)bits;
}
[[nodiscard]] TROPHIC_LANES_INLINE Real real_from(const Mask& bits) {
  return (Real)bits;
}
[[nodiscard]] TROPHIC_LANES_INLINE unsigned lane_bits(const Mask& mask) {
  return four_bits(mask);
}

/// Bit i set: lane i of a mask is all ones.
[[nodiscard]] TROPHIC_LANES_INLINE Mask mask_of(unsigned lanes) {
  constexpr Mask bits = {1, 2, 4, 8};
  const Mask all = Mask{} + static_cast<long long>(lanes);
  return (all & bits) != 0;
}

/// Sums of lanes.
[[nodiscard]] TROPHIC_LANES_INLINE Four wholes(const Real& a, const Real& b, const Real& c) {
  const Real ab = __builtin_shufflevector(a, b, 0, 4, 2, 6) + __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Real cc = __builtin_shufflevector(c, Real{}, 0, 4, 2, 6) + __builtin_shufflevector(c, Real{}, 1, 5, 3, 7);
  return __builtin_shufflevector(ab, cc, 0, 1, 4, 5) + __builtin_shufflevector(ab, cc, 2, 3, 6, 7);
}

}  // namespace trophic::backend::kernel::in_double
#endif

namespace trophic::backend::kernel {
using namespace TROPHIC_LANES;
}

namespace trophic::backend::kernel::TROPHIC_LANES {

/// Bits of all lanes.
inline constexpr unsigned all_lanes = (1u << lane_count) - 1;

/// Sine and cosine: reduction to |r| <= pi/4 by multiples of pi/2 in three parts (Cody and Waite), Taylor series up to r^17 and
/// r^16, whose first omitted terms are below 1e-18.
TROPHIC_LANES_INLINE void sine_cosine(const Real& angle_rad, Real& sine, Real& cosine) {
  const Real shifted = angle_rad * (2.0 / std::numbers::pi) + to_nearest;
  const Mask quadrant = mask_from(shifted);
  const Real turns = shifted - to_nearest;
  const Real r = ((angle_rad - turns * right_angle[0]) - turns * right_angle[1]) - turns * right_angle[2];
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
  const Mask sine_sign = (quadrant & 2) << (sign_bit - 1);
  const Mask cosine_sign = ((quadrant + 1) & 2) << (sign_bit - 1);
  sine = real_from(mask_from(select(swapped, even, odd)) ^ sine_sign);
  cosine = real_from(mask_from(select(swapped, odd, even)) ^ cosine_sign);
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

}  // namespace trophic::backend::kernel::TROPHIC_LANES
