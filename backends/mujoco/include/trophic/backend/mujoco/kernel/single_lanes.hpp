// SPDX-License-Identifier: MIT
// Eight numbers in single precision side by side, one per robot.
#pragma once

#include <trophic/backend/mujoco/kernel/four.hpp>

// Doubles are rounded where they come into a lane.
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wfloat-conversion"

namespace trophic::backend::kernel::in_single {

/// Like those of in_double (lanes.hpp).
inline constexpr std::size_t lane_count = 8;
using Floats = float __attribute__((vector_size(lane_count * sizeof(float)), aligned(lane_count * sizeof(float))));
using Mask = int __attribute__((vector_size(lane_count * sizeof(int)), aligned(lane_count * sizeof(int))));

inline constexpr double largest_angle_rad = 1e3;
inline constexpr double to_nearest = 0x1.8p23;
inline constexpr double right_angle[3] = {0x1.92p+0, 0x1.fb4p-12, 0x1.4442d18p-24};
inline constexpr int sign_bit = 31;

/// A number per lane, which doubles are rounded to: a plain vector of floats takes no double.
struct Real {
  Real() = default;
  TROPHIC_LANES_INLINE Real(double value) : lanes{Floats{} + static_cast<float>(value)} {}  // NOLINT: as for vectors
  TROPHIC_LANES_INLINE explicit Real(const Floats& of) : lanes{of} {}

  [[nodiscard]] TROPHIC_LANES_INLINE float& operator[](std::size_t lane) { return reinterpret_cast<float*>(&lanes)[lane]; }
  [[nodiscard]] TROPHIC_LANES_INLINE double operator[](std::size_t lane) const { return static_cast<double>(lanes[lane]); }

  TROPHIC_LANES_INLINE friend Real operator+(const Real& a, const Real& b) { return Real{a.lanes + b.lanes}; }
  TROPHIC_LANES_INLINE friend Real operator-(const Real& a, const Real& b) { return Real{a.lanes - b.lanes}; }
  TROPHIC_LANES_INLINE friend Real operator*(const Real& a, const Real& b) { return Real{a.lanes * b.lanes}; }
  TROPHIC_LANES_INLINE friend Real operator/(const Real& a, const Real& b) { return Real{a.lanes / b.lanes}; }
  TROPHIC_LANES_INLINE friend Real operator-(const Real& a) { return Real{-a.lanes}; }
  TROPHIC_LANES_INLINE Real& operator+=(const Real& b) { return *this = *this + b; }
  TROPHIC_LANES_INLINE Real& operator-=(const Real& b) { return *this = *this - b; }
  TROPHIC_LANES_INLINE Real& operator*=(const Real& b) { return *this = *this * b; }
  TROPHIC_LANES_INLINE friend Mask operator<(const Real& a, const Real& b) { return a.lanes < b.lanes; }
  TROPHIC_LANES_INLINE friend Mask operator>(const Real& a, const Real& b) { return a.lanes > b.lanes; }
  TROPHIC_LANES_INLINE friend Mask operator<=(const Real& a, const Real& b) { return a.lanes <= b.lanes; }
  TROPHIC_LANES_INLINE friend Mask operator>=(const Real& a, const Real& b) { return a.lanes >= b.lanes; }
  TROPHIC_LANES_INLINE friend Mask operator!=(const Real& a, const Real& b) { return a.lanes != b.lanes; }

  Floats lanes;
};

[[nodiscard]] TROPHIC_LANES_INLINE Real broadcast(double value) {
  return Real{value};
}
[[nodiscard]] TROPHIC_LANES_INLINE Mask mask_from(const Real& bits) {
  return (Mask)bits.lanes;
}
[[nodiscard]] TROPHIC_LANES_INLINE Real real_from(const Mask& bits) {
  return Real{(Floats)bits};
}
[[nodiscard]] TROPHIC_LANES_INLINE Real select(const Mask& mask, const Real& yes, const Real& no) {
  return Real{mask ? yes.lanes : no.lanes};
}
[[nodiscard]] TROPHIC_LANES_INLINE Real where(const Mask& mask, const Real& value) {
  return real_from(mask_from(value) & mask);
}
[[nodiscard]] TROPHIC_LANES_INLINE Real abs(const Real& value) {
  return real_from(mask_from(value) & 0x7fff'ffff);
}
[[nodiscard]] TROPHIC_LANES_INLINE unsigned lane_bits(const Mask& mask) {
#if defined(__SSE2__)
  const auto bits = (Floats)mask;
  return static_cast<unsigned>(_mm_movemask_ps(__builtin_shufflevector(bits, bits, 0, 1, 2, 3)) |
                               (_mm_movemask_ps(__builtin_shufflevector(bits, bits, 4, 5, 6, 7)) << 4));
#else
  unsigned bits = 0;
  for (std::size_t lane = 0; lane < lane_count; ++lane) bits |= (mask[lane] != 0 ? 1u : 0u) << lane;
  return bits;
#endif
}
[[nodiscard]] TROPHIC_LANES_INLINE Mask mask_of(unsigned lanes) {
  constexpr Mask bits = {1, 2, 4, 8, 16, 32, 64, 128};
  const Mask all = Mask{} + static_cast<int>(lanes);
  return (all & bits) != 0;
}
[[nodiscard]] TROPHIC_LANES_INLINE Real sqrt(const Real& value) {
#if defined(__SSE2__)
  const Floats& of = value.lanes;
  const __m128 low = _mm_sqrt_ps(__builtin_shufflevector(of, of, 0, 1, 2, 3));
  const __m128 high = _mm_sqrt_ps(__builtin_shufflevector(of, of, 4, 5, 6, 7));
  return Real{__builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7)};
#else
  Real root;
  for (std::size_t lane = 0; lane < lane_count; ++lane) root[lane] = std::sqrt(value[lane]);
  return root;
#endif
}
[[nodiscard]] TROPHIC_LANES_INLINE Four wholes(const Real& a, const Real& b, const Real& c) {
  Four sums{};
  for (std::size_t lane = 0; lane < lane_count; ++lane) sums += Four{a[lane], b[lane], c[lane], 0.0};
  return sums;
}

}  // namespace trophic::backend::kernel::in_single
