// SPDX-License-Identifier: MIT
// The states of four robots and the scratch memory of their step.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <trophic/backend/mujoco/kernel/box_contact.hpp>
#include <trophic/backend/mujoco/kernel/field_contact.hpp>
#include <trophic/backend/mujoco/kernel/model.hpp>
#include <trophic/backend/mujoco/kernel/spatial.hpp>
#include <trophic/backend/mujoco/kernel/symmetric_system.hpp>
#include <vector>

namespace trophic::backend::kernel {

/// States of four robots, laid out as in MuJoCo: position (root position, quaternion, joint angles), velocity (root linear
/// velocity in world axes, angular in the root's, joint velocities), acceleration of the last step (MuJoCo's qacc_warmstart).
struct LaneState {
  LaneArray position;
  LaneArray velocity;
  LaneArray acceleration;
  LaneArray target;

  explicit LaneState(const KernelModel& model)
      : position(model.hinges.size() + 7),
        velocity(model.hinges.size() + 6),
        acceleration(model.hinges.size() + 6),
        target(model.hinges.size()) {}

  /// Copies one robot in: its position, velocity and acceleration, one after the other, and its targets.
  void load(std::size_t lane, std::span<const double> numbers, std::span<const double> targets_rad) {
    load(lane, numbers);
    copy_in(lane, targets_rad, target);
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
  Vec3 anchor;           ///< of its hinge
  Vec3 sphere_centre;    ///< of the sphere that holds its boxes
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
  Spatial acceleration;  ///< of the current point of the search, without drift
  Spatial trial;         ///< of the point that the search tries
  Mask changed;          ///< where other rows of its contacts and its hinge push there than before
  bool is_stale;         ///< whether its articulated inertia must be computed anew
};

/// One hinge during a step.
struct HingeWork {
  Real torque;        ///< of the servo
  Real limit_weight;  ///< D of the joint limit's row, 0 where no limit is near
  Real limit_side;    ///< -1 at the lower limit, +1 at the upper
  Real limit_offset;  ///< row residual = offset - side * acceleration
  Mask limit_active;
  Real acceleration;
  Real trial;
};

/// One contact in up to four robots, at most one per lane. Coordinates are cyclic from the plane's axis: (a, a + 1, a + 2) mod 3.
struct ContactWork {
  Vec3 point;
  Real depth;      ///< signed distance, m, negative in contact
  Real weight;     ///< D of the four rows, 0 in a lane without this contact
  Vec3 offset;     ///< what is added to the point's acceleration so that the rows' residuals are projections of the sum
  Mask active[4];  ///< rows n + mu t1, n - mu t1, n + mu t2, n - mu t2 that push
  std::array<std::size_t, lane_count> memory;  ///< indices in the workspace's `pushing_rows`
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

/// One contact of two links, of one robot or of two.
struct LinkContact {
  std::array<std::size_t, 2> lane;
  std::array<std::size_t, 2> link;
  std::array<std::array<double, 3>, 2> point_m;  ///< from the origin of each robot's root
  std::array<std::array<double, 3>, 3> frame;    ///< normal from the first link to the second, and two tangents
  double depth_m;                                ///< signed distance, negative
};

/// One contact of a link with the height field.
struct FieldContact {
  std::size_t lane;
  std::size_t link;
  BoxContact contact;  ///< from the origin of the robot's root
};

/// A contact between links, or with the height field: rows y_n +- mu y_t1, y_n +- mu y_t2 of y = J x + offset.
struct CoupledContact {
  std::size_t first = 0;  ///< of the coordinates in x that move it, which ascend
  std::size_t coordinates = 0;
  std::size_t jacobian = 0;  ///< where its J begins
  double weight = 0.0;       ///< D of each row
  double mu = 0.0;
  std::array<double, 3> offset{};
  std::array<bool, 4> active{};

  [[nodiscard]] std::array<double, 4> pushing_weights() const {
    return {active[0] ? weight : 0.0, active[1] ? weight : 0.0, active[2] ? weight : 0.0, active[3] ? weight : 0.0};
  }
};

/// The search's current point: a link's motion, and the acceleration of its hinge to the parent.
struct TrialPoint {
  Spatial link;
  Real hinge;
};

/// The problem of robots whose links touch each other.
struct CoupledWork {
  std::vector<CoupledContact> contacts;
  std::vector<std::size_t> coordinates;
  std::vector<double> jacobians;   ///< J of each contact: its normal's row and its tangents', as long as columns of `system`
  std::vector<std::size_t> kept;   ///< links whose hinges are unknowns, leaves first
  std::vector<std::size_t> order;  ///< of each link among them; the number of links for the others
  std::vector<double> x;
  SymmetricSystem system;
  SymmetricSystem trees;  ///< A and b before contacts add to them
  std::vector<double> trees_x;
  std::vector<TrialPoint> trials;  ///< of lanes that are not being solved

  [[nodiscard]] std::span<const std::size_t> coordinates_of(const CoupledContact& contact) const {
    return {coordinates.data() + contact.first, contact.coordinates};
  }
  [[nodiscard]] std::array<const double*, 3> rows(const CoupledContact& contact) const {
    const double* const first = jacobians.data() + contact.jacobian;
    return {first, first + system.column_size(), first + 2 * system.column_size()};
  }
};

/// Scratch memory of one thread.
struct Workspace {
  /// Bits of the lanes that a lane's robot may touch, itself among them: these are stepped together or not at all.
  std::array<unsigned, lane_count> company;
  std::vector<LinkWork> links;
  std::vector<HingeWork> hinges;
  std::vector<ContactWork> contacts;
  std::vector<ContactGroup> groups;
  std::size_t group_count = 0;
  std::size_t contact_count = 0;
  /// Bits of the rows that pushed when a corner of a box last touched a plane, by plane, box, corner and lane.
  std::vector<std::uint8_t> pushing_rows;
  bool rows_known = false;               ///< whether these robots took a step since `forget_rows`
  std::vector<PlacedBox> placed_boxes;   ///< lane by lane, from the origin of each robot's root
  std::vector<std::uint8_t> box_placed;  ///< whether it is computed in this stage
  std::vector<Vec3> box_centres;         ///< of all robots, from the origins of their roots
  std::vector<std::uint8_t> last_gap;    ///< which axis last separated two boxes, lanes by lanes and boxes by boxes
  std::vector<LinkContact> link_contacts;
  std::vector<FieldContact> field_contacts;
  CoupledWork coupled;
  BoxCollider collider;
  std::optional<FieldCollider> field_collider;
  Mask doubtful{};  ///< lanes in which rounding decides what touches
  LaneState stage;  ///< start and sums of a Runge-Kutta step
  LaneState sum;

  explicit Workspace(const KernelModel& model)
      : links(model.links.size()),
        hinges(model.hinges.size()),
        contacts(model.planes.size() * model.boxes.size() * 4),
        groups(model.planes.size() * model.links.size()),
        pushing_rows(model.planes.size() * model.boxes.size() * 8 * lane_count, all_rows),
        placed_boxes(lane_count * model.boxes.size()),
        box_placed(placed_boxes.size()),
        box_centres(model.boxes.size()),
        last_gap(placed_boxes.size() * placed_boxes.size()),
        collider{model.box_depth},
        stage{model},
        sum{model} {
    if (model.field) field_collider.emplace(*model.field->model, model.field->geom);
    for (std::size_t lane = 0; lane < lane_count; ++lane) company[lane] = 1u << lane;
  }

  /// To be called when other robots come into the lanes.
  void forget_rows() {
    std::ranges::fill(pushing_rows, all_rows);
    rows_known = false;
  }
};

}  // namespace trophic::backend::kernel
