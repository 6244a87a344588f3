// SPDX-License-Identifier: MIT
// The constants of the bodies of a pack, one number per lane.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <trophic/backend/mujoco/kernel/body.hpp>
#include <trophic/backend/mujoco/kernel/lanes.hpp>
#include <vector>

namespace trophic::backend::kernel::TROPHIC_LANES {

/// A number per lane.
struct PerLane {
  using Number = Real;
  template <std::size_t Size>
  using Numbers = Real[Size];
};

/// As KernelBox.
struct LaneBox : BoxNumbers<PerLane> {
  bool aligned;
};

/// As KernelLink.
struct LaneLink : LinkNumbers<PerLane> {
  std::size_t parent;
  std::size_t first_box;
  std::size_t boxes;
};

using LaneHinge = HingeNumbers<PerLane>;

/// The constants of the bodies of a pack, which have the same shape.
class LaneModel {
 public:
  std::vector<LaneLink> links;
  std::vector<LaneHinge> hinges;
  std::vector<LaneBox> boxes;
  Real bounding_radius_m{};

  /// Any of the bodies, for everything that they share: tree, ground, friction, softness and physics.
  [[nodiscard]] const KernelModel& shape() const { return *bodies_[0]; }
  /// The body in a lane.
  [[nodiscard]] const KernelModel& body(std::size_t lane) const { return *bodies_[lane]; }

  /// Puts bodies with the same shape into the lanes; further lanes get the first one. A body that is in its lane already costs
  /// nothing.
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
  template <template <class> class Struct>
  static void put(const Struct<Plain>& from, Struct<PerLane>& to, std::size_t lane) {
    constexpr std::size_t size = sizeof from / sizeof(double);
    static_assert(sizeof to == size * sizeof(Real));
    const auto* const numbers = reinterpret_cast<const double*>(&from);
    auto* const lanes = reinterpret_cast<Real*>(&to);
    for (std::size_t i = 0; i < size; ++i) lanes[i][lane] = numbers[i];
  }

  void copy(const KernelModel& body, std::size_t lane) {
    bounding_radius_m[lane] = body.bounding_radius_m;
    for (std::size_t i = 0; i < links.size(); ++i) {
      put<LinkNumbers>(body.links[i], links[i], lane);
      links[i].parent = body.links[i].parent;
      links[i].first_box = body.links[i].first_box;
      links[i].boxes = body.links[i].boxes;
    }
    for (std::size_t i = 0; i < hinges.size(); ++i) put<HingeNumbers>(body.hinges[i], hinges[i], lane);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      put<BoxNumbers>(body.boxes[i], boxes[i], lane);
      boxes[i].aligned = body.boxes[i].aligned;
    }
  }

  std::array<std::shared_ptr<const KernelModel>, lane_count> bodies_;
};

}  // namespace trophic::backend::kernel::TROPHIC_LANES
