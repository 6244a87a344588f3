// SPDX-License-Identifier: MIT
// Contacts of boxes, and MuJoCo's frames for them.
#pragma once

#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <trophic/backend/mujoco/kernel/box_overlap.hpp>
#include <trophic/backend/mujoco/versions.hpp>

namespace trophic::backend::kernel {

/// A contact of a box with another box or the ground.
struct BoxContact {
  std::array<double, 3> point_m;
  std::array<std::array<double, 3>, 3> frame;  ///< normal towards the second box, and MuJoCo's two tangents
  double depth_m;                              ///< signed distance, negative
};

/// Leaves the points at which the boxes touch: of points that are one but for rounding the last, as MuJoCo does of equal points,
/// and of more than MuJoCo takes the deepest.
TROPHIC_LANES_INLINE void keep_contacts(BoxOverlap& overlap) {
  constexpr double rounding_m2 = 1e-20;
  auto& points_m = overlap.points_m;
  auto& depths_m = overlap.depths_m;
  std::size_t kept = 0;
  for (std::size_t c = 0; c < overlap.count; ++c) {
    bool taken = depths_m[c] < 0.0;
    for (std::size_t later = c + 1; later < overlap.count; ++later) {
      const Point3 between_m = minus(points_m[c], points_m[later]);
      taken &= dot3(between_m, between_m) >= rounding_m2;
    }
    if (!taken) continue;
    points_m[kept] = points_m[c];
    depths_m[kept++] = depths_m[c];
  }
  for (; kept > mujoco::most_box_contacts; --kept) {
    const auto shallowest = static_cast<std::size_t>(std::max_element(depths_m.data(), depths_m.data() + kept) - depths_m.data());
    std::shift_left(points_m.data() + shallowest, points_m.data() + kept, 1);
    std::shift_left(depths_m.data() + shallowest, depths_m.data() + kept, 1);
  }
  overlap.count = kept;
}

/// The least overlap of boxes that touch: far above the rounding of places, far below depths that matter.
inline constexpr double least_overlap_m = 1e-12;

/// Like MuJoCo's function and bitwise equal, but inlined: a vector of length 0 becomes the x axis.
inline void normalize3(std::array<double, 3>& vector) {
  const double length = std::sqrt(dot3(vector, vector));
  if (length < mjMINVAL) {
    vector = {1.0, 0.0, 0.0};
    return;
  }
  const double scale = 1.0 / length;
  for (double& part : vector) part *= scale;
}

/// Normal along `direction` and MuJoCo's choice of tangents: the first is the part across the normal of y, of z where the normal
/// is within 60 degrees of +-y; the second completes the frame.
[[nodiscard]] inline std::array<std::array<double, 3>, 3> contact_frame(const mjtNum* direction) {
  std::array<std::array<double, 3>, 3> frame{};
  auto& [normal, first, second] = frame;
  std::copy_n(direction, 3, normal.begin());
  normalize3(normal);
  const std::size_t axis = std::abs(normal[1]) < 0.5 ? 1 : 2;
  for (std::size_t i = 0; i < 3; ++i) first[i] = (i == axis ? 1.0 : 0.0) - normal[axis] * normal[i];
  normalize3(first);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    second[i] = normal[j] * first[k] - normal[k] * first[j];
  }
  return frame;
}

/// Moves geom `geom` to the position of `at`, shifted by `moved_m`.
inline void place_geom(mjData& data, std::size_t geom, const PlacedBox& at, const std::array<double, 3>& moved_m) {
  mju_add3(data.geom_xpos + 3 * geom, at.centre_m.data(), moved_m.data());
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < 3; ++i) data.geom_xmat[9 * geom + 3 * i + k] = at.axis[k][i];
  }
}

}  // namespace trophic::backend::kernel
