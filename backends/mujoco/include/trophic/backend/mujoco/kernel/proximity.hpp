// SPDX-License-Identifier: MIT
// Whether two links of one robot could touch: then the kernel leaves the step to MuJoCo.
#pragma once

#include <trophic/backend/mujoco/kernel/workspace.hpp>

namespace trophic::backend::kernel {

/// A box of one robot in world axes.
struct PlacedBox {
  double centre_m[3];
  double half_m[3];
  double axis[3][3];  ///< axis[k] is the direction of extent k
};

[[nodiscard]] TROPHIC_LANES_INLINE PlacedBox place_box(const KernelBox& box, const LinkWork& link, std::size_t lane) {
  PlacedBox placed;
  const Vec3 centre = link.anchor + rotate(link.rotation, box.centre_m.data());
  for (int i = 0; i < 3; ++i) placed.centre_m[i] = centre[i][lane];
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 axis = rotate(link.rotation, box.axes.data() + 3 * k);
    placed.half_m[k] = box.half_extents_m[k];
    for (int i = 0; i < 3; ++i) placed.axis[k][i] = axis[i][lane];
  }
  return placed;
}

/// True if one of the 15 separating axes of two boxes (their face normals and the products of their edges) shows a gap.
[[nodiscard]] TROPHIC_LANES_INLINE bool separated(const PlacedBox& a, const PlacedBox& b) {
  constexpr double gap_m = 1e-7;  // far above rounding, far below anything that matters
  double between[3];
  for (int i = 0; i < 3; ++i) between[i] = b.centre_m[i] - a.centre_m[i];
  const auto gap_along = [&](double x, double y, double z) {
    const double square = x * x + y * y + z * z;
    if (square < 1e-12) return false;
    double reach = gap_m * std::sqrt(square);
    for (int k = 0; k < 3; ++k) {
      reach += a.half_m[k] * std::abs(a.axis[k][0] * x + a.axis[k][1] * y + a.axis[k][2] * z);
      reach += b.half_m[k] * std::abs(b.axis[k][0] * x + b.axis[k][1] * y + b.axis[k][2] * z);
    }
    return std::abs(between[0] * x + between[1] * y + between[2] * z) > reach;
  };
  for (int k = 0; k < 3; ++k) {
    if (gap_along(a.axis[k][0], a.axis[k][1], a.axis[k][2])) return true;
    if (gap_along(b.axis[k][0], b.axis[k][1], b.axis[k][2])) return true;
  }
  for (const auto& u : a.axis) {
    for (const auto& v : b.axis) {
      if (gap_along(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])) return true;
    }
  }
  return false;
}

/// Lanes of `lanes` in which spheres around two centres overlap.
[[nodiscard]] TROPHIC_LANES_INLINE unsigned overlapping(const Vec3& a, const Vec3& b, double radius_m) {
  const Vec3 between = b - a;
  return lane_bits(dot(between, between) <= radius_m * radius_m);
}

/// Lanes of `lanes` in which any two links that MuJoCo would collide could touch: spheres around links, spheres around boxes,
/// then separating axes. Never misses a contact; a false alarm only costs time.
[[nodiscard]] TROPHIC_LANES_INLINE unsigned touching_links(const KernelModel& model, const Workspace& work, unsigned lanes) {
  unsigned touching = 0;
  for (const LinkPair& pair : model.pairs) {
    const KernelLink& first = model.links[pair.first];
    const KernelLink& second = model.links[pair.second];
    const LinkWork& first_pose = work.links[pair.first];
    const LinkWork& second_pose = work.links[pair.second];
    const unsigned near =
        overlapping(first_pose.sphere_centre, second_pose.sphere_centre, first.sphere_radius_m + second.sphere_radius_m) & lanes &
        ~touching;
    if (near == 0) continue;
    for (std::size_t a = first.first_box; a < first.first_box + first.boxes; ++a) {
      const KernelBox& box_a = model.boxes[a];
      const Vec3 centre_a = first_pose.anchor + rotate(first_pose.rotation, box_a.centre_m.data());
      for (std::size_t b = second.first_box; b < second.first_box + second.boxes; ++b) {
        const KernelBox& box_b = model.boxes[b];
        const Vec3 centre_b = second_pose.anchor + rotate(second_pose.rotation, box_b.centre_m.data());
        const unsigned close = overlapping(centre_a, centre_b, box_a.radius_m + box_b.radius_m) & near & ~touching;
        for (std::size_t lane = 0; lane < lane_count; ++lane) {
          if ((close & (1u << lane)) == 0) continue;
          if (!separated(place_box(box_a, first_pose, lane), place_box(box_b, second_pose, lane))) touching |= 1u << lane;
        }
      }
    }
  }
  return touching;
}

}  // namespace trophic::backend::kernel
