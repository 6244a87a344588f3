// SPDX-License-Identifier: MIT
// The states of robots of one shape and the scratch memory of their step.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <trophic/backend/mujoco/kernel/box_contact.hpp>
#include <trophic/backend/mujoco/kernel/lane_model.hpp>
#include <trophic/backend/mujoco/kernel/spatial.hpp>
#include <vector>

namespace trophic::backend::kernel::TROPHIC_LANES {

/// States of the robots in the lanes, laid out as in MuJoCo: position (root position, quaternion, joint angles), velocity (root
/// linear velocity in world axes, angular in the root's, joint velocities), acceleration of the last step (MuJoCo's
/// qacc_warmstart).
struct LaneState {
  LaneArray position;
  LaneArray velocity;
  LaneArray acceleration;
  LaneArray target;

  void fit(const KernelModel& model) {
    const std::size_t hinges = model.hinges.size();
    position.resize(hinges + 7);
    velocity.resize(hinges + 6);
    acceleration.resize(hinges + 6);
    target.resize(hinges);
  }

  /// Copies one robot in: its position, velocity and acceleration, one after the other, and its targets in the order of the
  /// RobotModel's hinges.
  void load(const KernelModel& model, std::size_t lane, std::span<const double> numbers, std::span<const double> targets_rad) {
    load(lane, numbers);
    for (std::size_t i = 0; i < target.size(); ++i) target[i][lane] = targets_rad[model.hinges[i].servo];
  }
  void load(std::size_t lane, std::span<const double> numbers) {
    copy_in(lane, numbers, position);
    copy_in(lane, numbers.subspan(position.size()), velocity);
    copy_in(lane, numbers.subspan(position.size() + velocity.size()), acceleration);
  }

  /// Copies one robot out.
  void store(std::size_t lane, std::span<double> numbers) const {
    copy_out(lane, position, numbers);
    copy_out(lane, velocity, numbers.subspan(position.size()));
    copy_out(lane, acceleration, numbers.subspan(position.size() + velocity.size()));
  }

 private:
  static void copy_in(std::size_t lane, std::span<const double> from, LaneArray& to) {
    for (std::size_t i = 0; i < to.size(); ++i) to[i][lane] = from[i];
  }
  static void copy_out(std::size_t lane, const LaneArray& from, std::span<double> to) {
    for (std::size_t i = 0; i < from.size(); ++i) to[i] = from[i][lane];
  }
};

/// One link during a step. Vectors are in world axes, points relative to the root's origin.
struct LinkWork {
  Mat3 rotation;         ///< directions of the link's axes
  Vec3 anchor;           ///< anchor of its hinge
  Vec3 sphere_centre;    ///< centre of the sphere that contains its boxes
  bool has_centres;      ///< whether those of its boxes are computed in this stage
  Spatial axis;          ///< S: motion of the link per unit of joint velocity
  RigidInertia inertia;  ///< I
  Spatial velocity;      ///< V
  Spatial drift;         ///< acceleration of the link when all joint accelerations are 0, gravity subtracted
  Spatial bias;          ///< p = I drift + V x* I V
  Inertia6 articulated;  ///< inertia of the subtree below the hinge as its parent feels it
  Spatial force;         ///< and its bias force
  Spatial reach;         ///< U = articulated S
  Real inverse;          ///< 1 / (S' U + joint terms)
  Real load;             ///< added to S' U: an active joint limit's D
  Real torque;           ///< joint torque minus S' force
  Spatial acceleration;  ///< acceleration at the current point of the search, without drift
  Spatial trial;         ///< acceleration at the trial point
  Mask changed;          ///< lanes in which the active rows of its contacts or its hinge changed
  bool is_stale;         ///< whether its articulated inertia must be recomputed
};

/// The centre of a box of a link, from the origin of the root.
[[nodiscard]] TROPHIC_LANES_INLINE Vec3 box_centre(const LinkWork& link, const LaneBox& box) {
  return link.anchor + rotate(link.rotation, box.centre_m);
}

/// One hinge during a step.
struct HingeWork {
  Real torque;        ///< torque of the servo
  Real limit_weight;  ///< D of the joint limit's row, 0 if no limit is near
  Real limit_side;    ///< -1 at the lower limit, +1 at the upper
  Real limit_offset;  ///< row residual = offset - side * acceleration
  Mask limit_active;
  Real acceleration;
  Real trial;
};

/// One contact per lane at most. Coordinates are cyclic from the plane's axis: (a, a + 1, a + 2) mod 3.
struct ContactWork {
  Vec3 point;
  Real depth;      ///< signed distance, m, negative in contact
  Real weight;     ///< D of the four rows, 0 in a lane without this contact
  Vec3 offset;     ///< added to the point's acceleration, so that the rows' residuals are projections of the sum
  Mask active[4];  ///< which of the rows n + mu t1, n - mu t1, n + mu t2, n - mu t2 are active
  std::array<std::size_t, lane_count> memory;  ///< indices in the workspace's `active_rows`
  Vec3 residual;                               ///< at the current point of the search
  Vec3 trial;
};

/// Bits of all four rows of a contact.
inline constexpr std::uint8_t all_rows = 0b1111;

/// The contacts of one link with one plane.
struct ContactGroup {
  std::size_t plane;
  std::size_t link;
  std::size_t first;
  std::size_t count;
};

/// One contact of a link with the height field.
struct FieldContact {
  std::size_t lane;
  std::size_t link;
  BoxContact contact;  ///< relative to the origin of the robot's root
};

/// A link of robots that touch each other or a height field.
struct IslandLink {
  Mask kept;     ///< lanes in which its hinge is an unknown of an island (island.hpp)
  Spatial link;  ///< trial motion of the lanes that have converged, while others have not
  Real hinge;    ///< and trial acceleration of its hinge
};

/// Scratch memory of the robots in the lanes.
struct Workspace {
  std::vector<LinkWork> links;
  std::vector<HingeWork> hinges;
  std::vector<ContactWork> contacts;
  std::vector<ContactGroup> groups;
  std::size_t group_count = 0;
  std::size_t contact_count = 0;
  /// Bits of the rows active when a corner of a box last touched a plane, by plane, box, corner and lane.
  std::vector<std::uint8_t> active_rows;
  bool rows_known = false;               ///< whether these robots took a step since `forget_rows`
  bool motion_known = false;             ///< whether there is a `counted_position`
  std::vector<PlacedBox> placed_boxes;   ///< lane by lane, from the origin of each robot's root
  std::vector<std::uint8_t> box_placed;  ///< whether it is computed in this stage
  std::vector<Vec3> box_centres;         ///< for all robots, relative to the origins of their roots, of links that have them
  /// For each link, a bound of how far any of its points has moved in all since its pack was filled, and the part due to its own
  /// joint; and the last position counted.
  LaneArray moved_m;
  LaneArray swung_m;
  LaneArray counted_position;
  std::vector<FieldContact> field_contacts;
  std::vector<IslandLink> island_links;
  Mask doubtful{};  ///< lanes in which rounding decides about contact
  LaneState stage;  ///< start and sums of a Runge-Kutta step
  LaneState sum;
  Vec3 turn{};  ///< that of the root from the start of the step to this stage

  /// Allocates memory for robots of this shape.
  void fit(const KernelModel& model) {
    const std::size_t boxes = model.boxes.size();
    links.resize(model.links.size());
    hinges.resize(model.hinges.size());
    contacts.resize(model.planes.size() * boxes * 4);
    groups.resize(model.planes.size() * model.links.size());
    active_rows.resize(model.planes.size() * boxes * 8 * lane_count);
    placed_boxes.resize(lane_count * boxes);
    box_placed.resize(placed_boxes.size());
    box_centres.resize(boxes);
    island_links.resize(links.size());
    moved_m.resize(links.size());
    swung_m.resize(links.size());
    counted_position.resize(model.hinges.size() + 7);
    stage.fit(model);
    sum.fit(model);
  }

  /// Must be called when the robots in the lanes change.
  void forget_rows() {
    std::ranges::fill(active_rows, all_rows);
    rows_known = false;
  }
};

}  // namespace trophic::backend::kernel::TROPHIC_LANES
