// SPDX-License-Identifier: MIT
// The constants of the bodies of a pack, one number per lane.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <trophic/backend/mujoco/kernel/lanes.hpp>
#include <trophic/backend/mujoco/kernel/model.hpp>
#include <vector>

namespace trophic::backend::kernel {

/// As KernelBox.
struct LaneBox {
  Real centre_m[3];
  Real half_extents_m[3];
  Real radius_m;
  Real axes[9];
  bool aligned;
};

/// As KernelLink.
struct LaneLink {
  std::size_t parent;
  std::size_t first_box;
  std::size_t boxes;
  Real offset_m[3];
  Real rotation[9];
  Real mass_kg;
  Real centre_of_mass_m[3];
  Real inertia_kgm2[6];
  Real sphere_centre_m[3];
  Real sphere_radius_m;
  Real inverse_weight_per_kg;
};

/// As KernelHinge.
struct LaneHinge {
  Real lower_rad;
  Real upper_rad;
  Real damping;
  Real inverse_weight;
  Real gain;
  Real bias;
  Real angle_gain;
  Real rate_gain;
  Real lowest_target_rad;
  Real highest_target_rad;
};

/// Whether two bodies in one arena may share a pack: the same tree with as many boxes on each link, and equal softness and
/// friction. Lengths, angles, masses and servos may differ.
[[nodiscard]] inline bool same_shape(const KernelModel& a, const KernelModel& b) {
  const auto same_link = [](const KernelLink& x, const KernelLink& y) { return x.parent == y.parent && x.boxes == y.boxes; };
  const auto same_box = [](const KernelBox& x, const KernelBox& y) { return x.aligned == y.aligned; };
  return a.friction == b.friction && a.link_friction == b.link_friction && a.damped == b.damped && a.law == b.law &&
         std::ranges::equal(a.links, b.links, same_link) && std::ranges::equal(a.boxes, b.boxes, same_box);
}

/// The constants of four bodies of one shape.
class LaneModel {
 public:
  std::vector<LaneLink> links;
  std::vector<LaneHinge> hinges;
  std::vector<LaneBox> boxes;
  Real bounding_radius_m{};

  /// Any of the bodies, for all that they share: tree, ground, friction, softness and physics.
  [[nodiscard]] const KernelModel& shape() const { return *bodies_[0]; }
  /// The body in a lane.
  [[nodiscard]] const KernelModel& body(std::size_t lane) const { return *bodies_[lane]; }

  /// Puts bodies of one shape into the lanes; lanes beyond them get the first. A body that is there already costs nothing.
  void set_bodies(std::span<const std::shared_ptr<const KernelModel>> bodies) {
    const KernelModel& first = *bodies.front();
    links.resize(first.links.size());
    hinges.resize(first.hinges.size());
    boxes.resize(first.boxes.size());
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      const auto& body = bodies[lane < bodies.size() ? lane : 0];
      if (bodies_[lane] == body) continue;
      copy(*body, lane);
      bodies_[lane] = body;
    }
  }

 private:
  static void put(double from, Real& to, std::size_t lane) { to[lane] = from; }
  template <std::size_t Size>
  static void put(const std::array<double, Size>& from, Real (&to)[Size], std::size_t lane) {
    for (std::size_t i = 0; i < Size; ++i) to[i][lane] = from[i];
  }

  void copy(const KernelModel& body, std::size_t lane) {
    put(body.bounding_radius_m, bounding_radius_m, lane);
    for (std::size_t i = 0; i < links.size(); ++i) {
      const KernelLink& from = body.links[i];
      LaneLink& to = links[i];
      to.parent = from.parent;
      to.first_box = from.first_box;
      to.boxes = from.boxes;
      put(from.offset_m, to.offset_m, lane);
      put(from.rotation, to.rotation, lane);
      put(from.mass_kg, to.mass_kg, lane);
      put(from.centre_of_mass_m, to.centre_of_mass_m, lane);
      put(from.inertia_kgm2, to.inertia_kgm2, lane);
      put(from.sphere_centre_m, to.sphere_centre_m, lane);
      put(from.sphere_radius_m, to.sphere_radius_m, lane);
      put(from.inverse_weight_per_kg, to.inverse_weight_per_kg, lane);
    }
    for (std::size_t i = 0; i < hinges.size(); ++i) {
      const KernelHinge& from = body.hinges[i];
      LaneHinge& to = hinges[i];
      put(from.lower_rad, to.lower_rad, lane);
      put(from.upper_rad, to.upper_rad, lane);
      put(from.damping, to.damping, lane);
      put(from.inverse_weight, to.inverse_weight, lane);
      put(from.gain, to.gain, lane);
      put(from.bias, to.bias, lane);
      put(from.angle_gain, to.angle_gain, lane);
      put(from.rate_gain, to.rate_gain, lane);
      put(from.lowest_target_rad, to.lowest_target_rad, lane);
      put(from.highest_target_rad, to.highest_target_rad, lane);
    }
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const KernelBox& from = body.boxes[i];
      LaneBox& to = boxes[i];
      put(from.centre_m, to.centre_m, lane);
      put(from.half_extents_m, to.half_extents_m, lane);
      put(from.radius_m, to.radius_m, lane);
      put(from.axes, to.axes, lane);
      to.aligned = from.aligned;
    }
  }

  std::array<std::shared_ptr<const KernelModel>, lane_count> bodies_;
};

}  // namespace trophic::backend::kernel
