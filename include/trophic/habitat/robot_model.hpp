// SPDX-License-Identifier: MIT
// The robot for any physics engine: rigid links, boxes and servo-driven hinges. Backends read only this model.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <trophic/params/params.hpp>
#include <vector>

namespace trophic {

/// A uniform solid box fixed to a link; both collision shape and mass.
struct Box {
  std::string part;  ///< its module part, e.g. "servo_body"
  Eigen::Vector3d half_extents_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();               ///< in the link's frame
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< box frame to link frame
  double mass_kg = 0.0;

  static constexpr auto fields() {
    return std::tuple{field("part", &Box::part), field("half_extents_m", &Box::half_extents_m), field("centre_m", &Box::centre_m),
                      field("orientation", &Box::orientation), field("mass_kg", &Box::mass_kg)};
  }
};

/// A rigid body. Link 0 is the root (free in space); hinge i - 1 attaches link i > 0 to `parent`. A link's frame has its origin
/// in its hinge's anchor; at joint angle 0 it is at `offset_m`, `rotation` in the parent's frame.
struct Link {
  std::string name;
  int parent = -1;  ///< index of the parent link, smaller than its own index; -1 for the root
  Eigen::Vector3d offset_m = Eigen::Vector3d::Zero();
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  double mass_kg = 0.0;
  Eigen::Vector3d centre_of_mass_m = Eigen::Vector3d::Zero();  ///< in the link's frame
  Eigen::Matrix3d inertia_kgm2 = Eigen::Matrix3d::Zero();      ///< about the centre of mass, axes of the link's frame
  std::vector<Box> boxes;

  static constexpr auto fields() {
    return std::tuple{field("name", &Link::name),
                      field("parent", &Link::parent),
                      field("offset_m", &Link::offset_m),
                      field("rotation", &Link::rotation),
                      field("mass_kg", &Link::mass_kg),
                      field("centre_of_mass_m", &Link::centre_of_mass_m),
                      field("inertia_kgm2", &Link::inertia_kgm2),
                      field("boxes", &Link::boxes)};
  }
};

/// Position servo: torque = position_gain (target - angle) - velocity_gain * velocity, N m; targets are clipped to
/// +-target_limit_rad.
struct Servo {
  double position_gain = 5.0;
  double velocity_gain = 0.05;
  double target_limit_rad = 1.0;

  static constexpr auto fields() {
    return std::tuple{field("position_gain", &Servo::position_gain), field("velocity_gain", &Servo::velocity_gain),
                      field("target_limit_rad", &Servo::target_limit_rad)};
  }
};

/// A one-axis joint between link `index + 1` and its parent; anchor = origin of that link's frame.
struct Hinge {
  std::string name;                                         ///< path of faces from the core, e.g. "back.front"
  Eigen::Vector3d axis = Eigen::Vector3d::UnitY();          ///< unit vector in the child link's frame
  double range_rad = 0.0;                                   ///< limits at +-range_rad
  Eigen::Vector3i grid_position = Eigen::Vector3i::Zero();  ///< module grid cell relative to the core
  Servo servo;

  static constexpr auto fields() {
    return std::tuple{field("name", &Hinge::name), field("axis", &Hinge::axis), field("range_rad", &Hinge::range_rad),
                      field("grid_position", &Hinge::grid_position), field("servo", &Hinge::servo)};
  }
};

/// A robot's walk with its own gait, steered to one side: measured once in an engine with joints (gait_evolution/trial.hpp) and
/// written to its file. Backends without joints move the robot by these two numbers; 0 and 0 mean not measured.
struct MeasuredWalk {
  double speed_m_s = 0.0;          ///< along the heading
  double turn_rate_per_rad = 0.0;  ///< rad/s to the right per rad of target angle

  static constexpr auto fields() {
    return std::tuple{field("speed_m_s", &MeasuredWalk::speed_m_s, between(0.0, 100.0)),
                      field("turn_rate_per_rad", &MeasuredWalk::turn_rate_per_rad, between(0.0, 100.0))};
  }
};

/// A whole robot. Invariants (checked by `validate(RobotModel)` in habitat/validate_robot.hpp): links.size() == hinges.size() +
/// 1, parents before children, masses > 0, inertias positive definite.
struct RobotModel {
  std::string name;
  std::string gait;  ///< name or path of its default gait
  MeasuredWalk walk;
  std::vector<Link> links;
  std::vector<Hinge> hinges;
  std::vector<std::vector<std::size_t>> hinge_neighbours;  ///< for hinge i the hinges within module-tree distance 2, ascending
  double friction = 1.0;                                   ///< sliding friction coefficient of all boxes
  double forward_rad = 0.0;    ///< direction of the robot's forward axis in the root frame, from x counter-clockwise
  double rest_height_m = 0.0;  ///< height of the root frame above the floor when the lowest box corner touches it, all angles 0
  double bounding_radius_m = 0.0;  ///< upper bound for the distance of any box point from the root frame's origin, at any angles

  static constexpr auto fields() {
    return std::tuple{field("name", &RobotModel::name),
                      field("gait", &RobotModel::gait),
                      field("walk", &RobotModel::walk),
                      field("links", &RobotModel::links),
                      field("hinges", &RobotModel::hinges),
                      field("hinge_neighbours", &RobotModel::hinge_neighbours),
                      field("friction", &RobotModel::friction),
                      field("forward_rad", &RobotModel::forward_rad),
                      field("rest_height_m", &RobotModel::rest_height_m),
                      field("bounding_radius_m", &RobotModel::bounding_radius_m)};
  }

  [[nodiscard]] double mass_kg() const {
    double sum = 0.0;
    for (const Link& link : links) sum += link.mass_kg;
    return sum;
  }
};

}  // namespace trophic
