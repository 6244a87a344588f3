// SPDX-License-Identifier: MIT
// Definitions of build.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <trophic/habitat/body/build.hpp>
#include <trophic/habitat/reach.hpp>
#include <trophic/habitat/validate_robot.hpp>

namespace trophic::body {

namespace detail {

using Frame = Eigen::Isometry3d;

[[nodiscard]] inline Frame shifted(const Frame& frame, double x_m) {
  return frame * Eigen::Translation3d{x_m, 0.0, 0.0};
}

[[nodiscard]] inline Frame rotated(const Frame& frame, const Eigen::Matrix3i& rotation) {
  Frame result = frame;
  result.linear() = frame.linear() * rotation.cast<double>();
  return result;
}

/// Mass, centre and inertia of the sum of a link's boxes: I = sum R I_box R^T + m (d.d 1 - d d^T), d from the common centre.
inline void sum_boxes(Link& link) {
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (const Box& box : link.boxes) {
    link.mass_kg += box.mass_kg;
    moment += box.mass_kg * box.centre_m;
  }
  link.centre_of_mass_m = moment / link.mass_kg;
  for (const Box& box : link.boxes) {
    const Eigen::Vector3d squared = box.half_extents_m.cwiseAbs2();
    const Eigen::Vector3d own = box.mass_kg / 3.0 * (Eigen::Vector3d::Constant(squared.sum()) - squared);
    const Eigen::Matrix3d rotation = box.orientation.toRotationMatrix();
    const Eigen::Vector3d d = box.centre_m - link.centre_of_mass_m;
    link.inertia_kgm2 += rotation * own.asDiagonal() * rotation.transpose() +
                         box.mass_kg * (d.squaredNorm() * Eigen::Matrix3d::Identity() - d * d.transpose());
  }
}

/// Depth-first walk over the tree that fills links and hinges.
class Builder {
 public:
  explicit Builder(const Design& design) : design_{design} {
    robot_.name = design.name;
    robot_.gait = design.gait;
    robot_.walk = design.walk;
    robot_.friction = design.friction;
    robot_.forward_rad = design.forward_deg * std::numbers::pi / 180.0;
    robot_.links.emplace_back().name = "core";
    const Frame centre = Frame::Identity();
    add_box(0, "core", centre, parts::core_extents_m, design.part_mass_kg.core);
    add_children(0, 0, centre, parts::core_face_m);
    for (Link& link : robot_.links) sum_boxes(link);
    connect_neighbours();
    measure();
  }

  [[nodiscard]] RobotModel take() { return std::move(robot_); }

 private:
  void add_box(std::size_t link, std::string_view part, const Frame& centre, const Eigen::Vector3d& extents_m, double mass_kg) {
    const bool by_density = link == 0 && design_.root_density_kg_m3;
    robot_.links[link].boxes.push_back({.part = std::string{part},
                                        .half_extents_m = extents_m / 2.0,
                                        .centre_m = centre.translation(),
                                        .orientation = Eigen::Quaterniond{centre.linear()}.normalized(),
                                        .mass_kg = by_density ? *design_.root_density_kg_m3 * extents_m.prod() : mass_kg});
  }

  /// `centre`: frame of the module in its link, with its faces `face_m` away.
  void add_children(std::size_t module, std::size_t link, const Frame& centre, double face_m) {
    for (const Face face : all_faces) {
      const auto child = design_.modules.child(module, face);
      if (!child) continue;
      const Frame attachment = rotated(shifted(rotated(centre, face_rotation(face)), face_m),
                                       roll_rotation(design_.modules.modules()[*child].quarter_turns));
      if (design_.modules.modules()[*child].type == ModuleType::hinge) {
        add_hinge(*child, link, attachment);
      } else {
        const Frame middle = shifted(attachment, parts::brick_face_m);
        add_box(link, "brick", middle, parts::brick_extents_m, design_.part_mass_kg.brick);
        add_children(*child, link, middle, parts::brick_face_m);
      }
    }
  }

  void add_hinge(std::size_t module, std::size_t parent_link, const Frame& attachment) {
    add_box(parent_link, "hinge_frame", shifted(attachment, parts::hinge_frame_m), parts::hinge_frame_extents_m,
            design_.part_mass_kg.hinge_frame);
    const Frame anchor = shifted(attachment, parts::servo_body_m + parts::joint_from_servo_body_m);
    const std::string name = design_.modules.path(module);
    const std::size_t link = robot_.links.size();
    Link& moving = robot_.links.emplace_back();
    moving.name = name;
    moving.parent = static_cast<int>(parent_link);
    moving.offset_m = anchor.translation();
    moving.rotation = Eigen::Quaterniond{anchor.linear()}.normalized();
    robot_.hinges.push_back({.name = name,
                             .axis = Eigen::Vector3d::UnitY(),
                             .range_rad = design_.hinge_range_rad,
                             .grid_position = design_.modules.modules()[module].cell,
                             .servo = design_.servo});
    hinge_modules_.push_back(module);
    const Frame servo = shifted(Frame::Identity(), -parts::joint_from_servo_body_m);
    add_box(link, "servo_body", servo, parts::servo_body_extents_m, design_.part_mass_kg.servo_body);
    add_box(link, "servo_plate", shifted(servo, parts::servo_plate_from_servo_body_m), parts::servo_plate_extents_m,
            design_.part_mass_kg.servo_plate);
    add_children(module, link, servo, parts::hinge_face_from_servo_body_m);
  }

  void connect_neighbours() {
    robot_.hinge_neighbours.resize(hinge_modules_.size());
    for (std::size_t i = 0; i < hinge_modules_.size(); ++i) {
      for (std::size_t j = 0; j < hinge_modules_.size(); ++j) {
        if (i != j && design_.modules.distance(hinge_modules_[i], hinge_modules_[j]) <= 2) {
          robot_.hinge_neighbours[i].push_back(j);
        }
      }
    }
  }

  void measure() {
    std::vector<Frame> rest(robot_.links.size(), Frame::Identity());  // link frame to root frame, all angles 0
    double lowest_m = 0.0;
    for (std::size_t i = 0; i < robot_.links.size(); ++i) {
      const Link& link = robot_.links[i];
      if (link.parent >= 0) {
        rest[i] = rest[static_cast<std::size_t>(link.parent)] * Eigen::Translation3d{link.offset_m} * link.rotation;
      }
      for (const Box& box : link.boxes) {
        for (const Eigen::Vector3d& corner : corners(box)) {
          lowest_m = std::min(lowest_m, (rest[i] * corner).z());
        }
      }
    }
    robot_.rest_height_m = -lowest_m;
    robot_.bounding_radius_m = reach_m(robot_);
  }

  const Design& design_;
  RobotModel robot_;
  std::vector<std::size_t> hinge_modules_;
};

}  // namespace detail

TROPHIC_INLINE RobotModel build(const Design& design) {
  validate(design, design.name);
  RobotModel robot = detail::Builder{design}.take();
  validate(robot);
  return robot;
}

}  // namespace trophic::body
