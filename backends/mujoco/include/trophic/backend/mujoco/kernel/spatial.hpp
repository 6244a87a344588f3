// SPDX-License-Identifier: MIT
// Vectors, rotations and spatial (six-dimensional) algebra on lanes.
#pragma once

#include <trophic/backend/mujoco/kernel/lanes.hpp>

namespace trophic::backend::kernel::TROPHIC_LANES {

struct Vec3 {
  Real v[3];
  TROPHIC_LANES_INLINE Real& operator[](int i) { return v[i]; }
  TROPHIC_LANES_INLINE const Real& operator[](int i) const { return v[i]; }
};

[[nodiscard]] TROPHIC_LANES_INLINE Vec3 operator+(const Vec3& a, const Vec3& b) {
  return {{a[0] + b[0], a[1] + b[1], a[2] + b[2]}};
}
[[nodiscard]] TROPHIC_LANES_INLINE Vec3 operator-(const Vec3& a, const Vec3& b) {
  return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}};
}
[[nodiscard]] TROPHIC_LANES_INLINE Vec3 operator*(const Vec3& a, const Real& s) {
  return {{a[0] * s, a[1] * s, a[2] * s}};
}
[[nodiscard]] TROPHIC_LANES_INLINE Real dot(const Vec3& a, const Vec3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
[[nodiscard]] TROPHIC_LANES_INLINE Vec3 cross(const Vec3& a, const Vec3& b) {
  return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}
[[nodiscard]] TROPHIC_LANES_INLINE Vec3 select(const Mask& mask, const Vec3& yes, const Vec3& no) {
  return {{select(mask, yes[0], no[0]), select(mask, yes[1], no[1]), select(mask, yes[2], no[2])}};
}

/// A rotation by its columns: the world directions of a frame's axes.
struct Mat3 {
  Vec3 column[3];
};

[[nodiscard]] TROPHIC_LANES_INLINE Vec3 operator*(const Mat3& m, const Vec3& a) {
  return m.column[0] * a[0] + m.column[1] * a[1] + m.column[2] * a[2];
}
/// The rotation times a vector of constants.
[[nodiscard]] TROPHIC_LANES_INLINE Vec3 rotate(const Mat3& m, const Real* a) {
  Vec3 r;
  for (int i = 0; i < 3; ++i) r[i] = m.column[0][i] * a[0] + m.column[1][i] * a[1] + m.column[2][i] * a[2];
  return r;
}
[[nodiscard]] TROPHIC_LANES_INLINE Vec3 transposed_times(const Mat3& m, const Vec3& a) {
  return {{dot(m.column[0], a), dot(m.column[1], a), dot(m.column[2], a)}};
}

/// A motion (angular, linear velocity or acceleration) or a force (torque, force); both relative to the origin of the robot's
/// root, in world axes.
struct Spatial {
  Vec3 angular;
  Vec3 linear;
};

[[nodiscard]] TROPHIC_LANES_INLINE Spatial operator+(const Spatial& a, const Spatial& b) {
  return {a.angular + b.angular, a.linear + b.linear};
}
[[nodiscard]] TROPHIC_LANES_INLINE Spatial operator-(const Spatial& a, const Spatial& b) {
  return {a.angular - b.angular, a.linear - b.linear};
}
[[nodiscard]] TROPHIC_LANES_INLINE Spatial operator*(const Spatial& a, const Real& s) {
  return {a.angular * s, a.linear * s};
}
[[nodiscard]] TROPHIC_LANES_INLINE Real dot(const Spatial& a, const Spatial& b) {
  return dot(a.angular, b.angular) + dot(a.linear, b.linear);
}
/// Rate of change of motion m that is carried along by motion v: v x m.
[[nodiscard]] TROPHIC_LANES_INLINE Spatial cross_motion(const Spatial& v, const Spatial& m) {
  return {cross(v.angular, m.angular), cross(v.angular, m.linear) + cross(v.linear, m.angular)};
}
/// Rate of change of force f that is carried along by motion v: v x* f.
[[nodiscard]] TROPHIC_LANES_INLINE Spatial cross_force(const Spatial& v, const Spatial& f) {
  return {cross(v.angular, f.angular) + cross(v.linear, f.linear), cross(v.angular, f.linear)};
}
/// Motion of the body's point at `point` (relative to the root's origin).
[[nodiscard]] TROPHIC_LANES_INLINE Vec3 point_motion(const Spatial& v, const Vec3& point) {
  return v.linear + cross(v.angular, point);
}

/// Symmetric 3x3 matrix: xx, yy, zz, xy, xz, yz.
struct Sym3 {
  Real v[6];
  [[nodiscard]] static constexpr int index(int row, int column) { return row == column ? row : row + column + 2; }
  TROPHIC_LANES_INLINE Real& operator()(int row, int column) { return v[index(row, column)]; }
  TROPHIC_LANES_INLINE const Real& operator()(int row, int column) const { return v[index(row, column)]; }
};

[[nodiscard]] TROPHIC_LANES_INLINE Vec3 operator*(const Sym3& s, const Vec3& a) {
  return {{s.v[0] * a[0] + s.v[3] * a[1] + s.v[4] * a[2], s.v[3] * a[0] + s.v[1] * a[1] + s.v[5] * a[2],
           s.v[4] * a[0] + s.v[5] * a[1] + s.v[2] * a[2]}};
}

/// Inverse by cofactors; the matrix must be positive definite.
[[nodiscard]] TROPHIC_LANES_INLINE Sym3 inverse(const Sym3& s) {
  const Real xx = s.v[1] * s.v[2] - s.v[5] * s.v[5];
  const Real xy = s.v[4] * s.v[5] - s.v[3] * s.v[2];
  const Real xz = s.v[3] * s.v[5] - s.v[1] * s.v[4];
  const Real scale = 1.0 / (s.v[0] * xx + s.v[3] * xy + s.v[4] * xz);
  return {{xx * scale, (s.v[0] * s.v[2] - s.v[4] * s.v[4]) * scale, (s.v[0] * s.v[1] - s.v[3] * s.v[3]) * scale, xy * scale,
           xz * scale, (s.v[3] * s.v[4] - s.v[0] * s.v[5]) * scale}};
}

/// Inertia of a rigid body: mass, mass times centre of mass, rotational inertia, both about the root's origin.
struct RigidInertia {
  Real mass_kg;
  Vec3 moment;
  Sym3 rotational;
};

/// Momentum or inertial force I v = (I_rot w + h x v, m v - h x w).
[[nodiscard]] TROPHIC_LANES_INLINE Spatial operator*(const RigidInertia& inertia, const Spatial& v) {
  const Vec3 hv = cross(inertia.moment, v.linear);
  const Vec3 hw = cross(inertia.moment, v.angular);
  Spatial f;
  f.angular = inertia.rotational * v.angular + hv;
  for (int i = 0; i < 3; ++i) f.linear[i] = inertia.mass_kg * v.linear[i] - hw[i];
  return f;
}

/// Articulated inertia: any symmetric 6x6 matrix [angular, coupling; coupling', linear].
struct Inertia6 {
  Sym3 angular;
  Real coupling[3][3];
  Sym3 linear;
};

/// As an articulated inertia; written in place, as a copy of so many lanes is slow.
TROPHIC_LANES_INLINE void expand(const RigidInertia& inertia, Inertia6& to) {
  const Vec3& h = inertia.moment;
  auto& c = to.coupling;
  to.angular = inertia.rotational;
  c[0][0] = c[1][1] = c[2][2] = Real{};
  c[0][1] = -h[2];
  c[0][2] = h[1];
  c[1][0] = h[2];
  c[1][2] = -h[0];
  c[2][0] = -h[1];
  c[2][1] = h[0];
  for (int i = 0; i < 3; ++i) {
    to.linear.v[i] = inertia.mass_kg;
    to.linear.v[3 + i] = Real{};
  }
}

[[nodiscard]] TROPHIC_LANES_INLINE Spatial operator*(const Inertia6& inertia, const Spatial& v) {
  const auto& c = inertia.coupling;
  Spatial f = {inertia.angular * v.angular, inertia.linear * v.linear};
  for (int i = 0; i < 3; ++i) {
    f.angular[i] += c[i][0] * v.linear[0] + c[i][1] * v.linear[1] + c[i][2] * v.linear[2];
    f.linear[i] += c[0][i] * v.angular[0] + c[1][i] * v.angular[1] + c[2][i] * v.angular[2];
  }
  return f;
}

}  // namespace trophic::backend::kernel::TROPHIC_LANES
