// SPDX-License-Identifier: MIT
// Whether links of a robot, or robots, could touch each other: then the kernel leaves the step to MuJoCo.
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

/// Lanes in which spheres around two centres overlap.
[[nodiscard]] TROPHIC_LANES_INLINE unsigned overlapping(const Vec3& a, const Vec3& b, double radius_m) {
  const Vec3 between = b - a;
  return lane_bits(dot(between, between) <= radius_m * radius_m);
}

/// A link of the robot in one lane.
struct LinkOf {
  const KernelLink& link;
  const LinkWork& pose;
  std::size_t lane;
};

/// Whether boxes of two links could touch: spheres around boxes, then separating axes. `apart_m`: from the origin of a's robot to
/// that of b's.
[[nodiscard]] TROPHIC_LANES_INLINE bool boxes_touch(const KernelModel& model, const LinkOf& a, const LinkOf& b,
                                                    const double (&apart_m)[3]) {
  for (std::size_t i = a.link.first_box; i < a.link.first_box + a.link.boxes; ++i) {
    const KernelBox& box_a = model.boxes[i];
    const Vec3 centre_a = a.pose.anchor + rotate(a.pose.rotation, box_a.centre_m.data());
    for (std::size_t j = b.link.first_box; j < b.link.first_box + b.link.boxes; ++j) {
      const KernelBox& box_b = model.boxes[j];
      const Vec3 centre_b = b.pose.anchor + rotate(b.pose.rotation, box_b.centre_m.data());
      double square_m2 = 0.0;
      for (int k = 0; k < 3; ++k) {
        const double between_m = centre_b[k][b.lane] + apart_m[k] - centre_a[k][a.lane];
        square_m2 += between_m * between_m;
      }
      const double reach_m = box_a.radius_m + box_b.radius_m;
      if (square_m2 > reach_m * reach_m) continue;
      const PlacedBox placed_a = place_box(box_a, a.pose, a.lane);
      PlacedBox placed_b = place_box(box_b, b.pose, b.lane);
      for (int k = 0; k < 3; ++k) placed_b.centre_m[k] += apart_m[k];
      if (!separated(placed_a, placed_b)) return true;
    }
  }
  return false;
}

/// Lanes of `lanes` in which any two links that MuJoCo would collide could touch. Never misses a contact; a false alarm only
/// costs time.
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
    for (std::size_t lane = 0; near != 0 && lane < lane_count; ++lane) {
      if ((near & (1u << lane)) == 0) continue;
      if (boxes_touch(model, {first, first_pose, lane}, {second, second_pose, lane}, {0.0, 0.0, 0.0})) touching |= 1u << lane;
    }
  }
  return touching;
}

/// Whether the robots in two lanes could touch each other: spheres around robots, around links, then boxes.
[[nodiscard]] TROPHIC_LANES_INLINE bool robots_touch(const KernelModel& model, const LaneState& state, const Workspace& work,
                                                     std::size_t a, std::size_t b) {
  double apart_m[3];
  for (std::size_t k = 0; k < 3; ++k) apart_m[k] = state.position[k][b] - state.position[k][a];
  const double square_m2 = apart_m[0] * apart_m[0] + apart_m[1] * apart_m[1] + apart_m[2] * apart_m[2];
  if (square_m2 > 4.0 * model.bounding_radius_m * model.bounding_radius_m) return false;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const LinkOf first{model.links[i], work.links[i], a};
    for (std::size_t j = 0; j < model.links.size(); ++j) {
      const LinkOf second{model.links[j], work.links[j], b};
      double between_m2 = 0.0;
      for (int k = 0; k < 3; ++k) {
        const double between_m = second.pose.sphere_centre[k][b] + apart_m[k] - first.pose.sphere_centre[k][a];
        between_m2 += between_m * between_m;
      }
      const double reach_m = first.link.sphere_radius_m + second.link.sphere_radius_m;
      if (between_m2 <= reach_m * reach_m && boxes_touch(model, first, second, apart_m)) return true;
    }
  }
  return false;
}

/// Lanes of `lanes` whose robot could touch another of its company.
[[nodiscard]] TROPHIC_LANES_INLINE unsigned touching_robots(const KernelModel& model, const LaneState& state,
                                                            const Workspace& work, unsigned lanes) {
  unsigned touching = 0;
  for (std::size_t b = 1; b < lane_count; ++b) {
    const unsigned others = work.company[b] & lanes & ((1u << b) - 1);
    for (std::size_t a = 0; others != 0 && (lanes & (1u << b)) != 0 && a < b; ++a) {
      if ((others & (1u << a)) != 0 && robots_touch(model, state, work, a, b)) touching |= (1u << a) | (1u << b);
    }
  }
  return touching;
}

/// Lanes of `lanes` whose whole company is in `lanes`.
[[nodiscard]] TROPHIC_LANES_INLINE unsigned complete(const Workspace& work, unsigned lanes) {
  unsigned whole = lanes;
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    if ((work.company[lane] & ~lanes) != 0) whole &= ~(1u << lane);
  }
  return whole;
}

}  // namespace trophic::backend::kernel
