// SPDX-License-Identifier: MIT
// One robot in an ODE world: bodies, boxes, hinges and servos of a RobotModel.
#pragma once

#include <ode/ode.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <trophic/backend/ode/compliance.hpp>
#include <trophic/backend/ode/engine.hpp>
#include <trophic/backend/ode/params.hpp>
#include <trophic/backend/ode/state.hpp>
#include <trophic/habitat/pose.hpp>
#include <trophic/habitat/robot_model.hpp>
#include <trophic/support/units.hpp>

namespace trophic::backend::ode {

/// ODE's bodies have their origin in the centre of mass, with the axes of the link's frame.
[[nodiscard]] inline Pose link_frame(const LinkState& state, const Link& link) {
  const Eigen::Quaterniond rotation{state.rotation[0], state.rotation[1], state.rotation[2], state.rotation[3]};
  const Eigen::Vector3d centre_m{state.position_m[0], state.position_m[1], state.position_m[2]};
  return {.position_m = centre_m - rotation * link.centre_of_mass_m, .orientation = rotation};
}

[[nodiscard]] inline LinkState link_at(const Pose& frame, const Link& link) {
  const Eigen::Vector3d centre_m = frame.position_m + frame.orientation * link.centre_of_mass_m;
  const Eigen::Quaterniond& q = frame.orientation;
  return {.position_m = {centre_m.x(), centre_m.y(), centre_m.z()}, .rotation = {q.w(), q.x(), q.y(), q.z()}};
}

/// Appends the links of a robot at rest with all angles 0 to `links`.
inline void append_at_rest(const RobotModel& model, const Pose& root, std::vector<LinkState>& links) {
  std::vector<Pose> frames;
  for (const Link& link : model.links) {
    Pose frame = root;
    frame.orientation.normalize();
    if (link.parent >= 0) {
      const Pose& parent = frames[static_cast<std::size_t>(link.parent)];
      frame = {.position_m = parent.position_m + parent.orientation * link.offset_m,
               .orientation = (parent.orientation * link.rotation).normalized()};
    }
    frames.push_back(frame);
    links.push_back(link_at(frame, link));
  }
}

/// Mass and inertia of a link about its centre of mass, as for an ODE body.
[[nodiscard]] inline dMass mass_of(const Link& link) {
  dMass mass;
  const Eigen::Matrix3d& i = link.inertia_kgm2;
  dMassSetParameters(&mass, link.mass_kg, 0.0, 0.0, 0.0, i(0, 0), i(1, 1), i(2, 2), i(0, 1), i(0, 2), i(1, 2));
  return mass;
}

/// The bodies, geoms and joints of one robot. Bodies and joints belong to the world and are destroyed with it; the geoms are
/// destroyed with the robot.
///
/// Servo: the hinge's stop with lower and upper stop at the target is a two-sided spring and damper between angle and target,
/// integrated implicitly with everything else in the step: torque = kp (target - angle') - kv velocity', with angle' and
/// velocity' at the step's end. The same torque as an explicit force needs a timestep below 5 ms to stay stable. A hinge beyond
/// its range has a second spring and damper, which only pushes back into the range; both add up to one in the same stop:
/// stiffness and damping are sums, the target is the mean of servo target and limit weighted with the stiffnesses.
class Robot {
 public:
  /// ODE measures hinge angles within (-pi, pi]; a hinge must not reach these.
  static constexpr double largest_range_rad = 3.0;

  struct Geom {
    GeomPtr geom;
    double radius_m = 0.0;
    std::size_t link = 0;
  };

  Robot(dWorldID world, const RobotModel& model, const Params& params, double timestep_s)
      : model_{model},
        limit_{.stiffness = params.limit_stiffness_N_m_rad, .damping = params.limit_damping_N_m_s_rad},
        timestep_s_{timestep_s} {
    std::vector<LinkState> at_rest;
    append_at_rest(model, Pose{}, at_rest);
    for (std::size_t i = 0; i < model.links.size(); ++i) add_body(world, i, at_rest[i]);
    for (std::size_t i = 0; i < model.hinges.size(); ++i) add_hinge(world, i, at_rest[i + 1]);
  }

  [[nodiscard]] std::span<const Geom> geoms() const { return geoms_; }
  [[nodiscard]] std::span<const dBodyID> bodies() const { return bodies_; }

  /// Pairs of geoms of different links that no hinge joins.
  [[nodiscard]] std::span<const std::pair<std::size_t, std::size_t>> self_pairs() const { return self_pairs_; }

  void load(std::span<const LinkState> links) {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const LinkState& link = links[i];
      dBodySetPosition(bodies_[i], link.position_m[0], link.position_m[1], link.position_m[2]);
      dBodySetQuaternion(bodies_[i], link.rotation.data());
      dBodySetLinearVel(bodies_[i], link.velocity_m_s[0], link.velocity_m_s[1], link.velocity_m_s[2]);
      dBodySetAngularVel(bodies_[i], link.spin_rad_s[0], link.spin_rad_s[1], link.spin_rad_s[2]);
    }
  }

  void store(std::span<LinkState> links, std::span<double> angles_rad) const {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const auto copy = [](const double* from, auto& to) { std::copy_n(from, to.size(), to.begin()); };
      copy(dBodyGetPosition(bodies_[i]), links[i].position_m);
      copy(dBodyGetQuaternion(bodies_[i]), links[i].rotation);
      copy(dBodyGetLinearVel(bodies_[i]), links[i].velocity_m_s);
      copy(dBodyGetAngularVel(bodies_[i]), links[i].spin_rad_s);
    }
    for (std::size_t i = 0; i < hinges_.size(); ++i) angles_rad[i] = dJointGetHingeAngle(hinges_[i]);
  }

  /// Sets each hinge's spring for the coming step; call after `load`.
  void set_servos(std::span<const double> angles_rad, std::span<const double> targets_rad) {
    for (std::size_t i = 0; i < hinges_.size(); ++i) {
      const Hinge& hinge = model_.hinges[i];
      Spring spring{.stiffness = hinge.servo.position_gain, .damping = hinge.servo.velocity_gain};
      double target_rad = targets_rad[i];
      const double beyond_rad = std::abs(angles_rad[i]) - hinge.range_rad;
      if (beyond_rad > 0.0) {
        const double side = angles_rad[i] > 0.0 ? 1.0 : -1.0;
        const double outward_rad_s = side * dJointGetHingeAngleRate(hinges_[i]);
        if (limit_.stiffness * beyond_rad + limit_.damping * outward_rad_s > 0.0) {
          const double both = spring.stiffness + limit_.stiffness;
          target_rad = (spring.stiffness * target_rad + limit_.stiffness * side * hinge.range_rad) / both;
          spring = {.stiffness = both, .damping = spring.damping + limit_.damping};
        }
      }
      set_stop(hinges_[i], spring, target_rad);
    }
  }

 private:
  void add_body(dWorldID world, std::size_t index, const LinkState& at_rest) {
    const Link& link = model_.links[index];
    const dBodyID body = dBodyCreate(world);
    bodies_.push_back(body);
    const dMass mass = mass_of(link);
    dBodySetMass(body, &mass);
    dBodySetFiniteRotationMode(body, 1);
    dBodySetPosition(body, at_rest.position_m[0], at_rest.position_m[1], at_rest.position_m[2]);
    dBodySetQuaternion(body, at_rest.rotation.data());
    const std::size_t before = geoms_.size();
    for (const Box& box : link.boxes) {
      const Eigen::Vector3d extents_m = 2.0 * box.half_extents_m;
      const Eigen::Vector3d centre_m = box.centre_m - link.centre_of_mass_m;
      GeomPtr geom{dCreateBox(nullptr, extents_m.x(), extents_m.y(), extents_m.z())};
      dGeomSetBody(geom.get(), body);
      dGeomSetOffsetPosition(geom.get(), centre_m.x(), centre_m.y(), centre_m.z());
      const dQuaternion q{box.orientation.w(), box.orientation.x(), box.orientation.y(), box.orientation.z()};
      dGeomSetOffsetQuaternion(geom.get(), q);
      geoms_.push_back({.geom = std::move(geom), .radius_m = box.half_extents_m.norm(), .link = index});
    }
    for (std::size_t other = 0; other < before; ++other) {
      if (static_cast<int>(geoms_[other].link) == link.parent) continue;
      for (std::size_t own = before; own < geoms_.size(); ++own) self_pairs_.emplace_back(other, own);
    }
  }

  void add_hinge(dWorldID world, std::size_t index, const LinkState& child_at_rest) {
    const Link& child = model_.links[index + 1];
    const Pose frame = link_frame(child_at_rest, child);
    const Eigen::Vector3d axis = frame.orientation * model_.hinges[index].axis;
    const dJointID hinge = dJointCreateHinge(world, nullptr);
    dJointAttach(hinge, bodies_[index + 1], bodies_[static_cast<std::size_t>(child.parent)]);
    dJointSetHingeAnchor(hinge, frame.position_m.x(), frame.position_m.y(), frame.position_m.z());
    dJointSetHingeAxis(hinge, axis.x(), axis.y(), axis.z());
    hinges_.push_back(hinge);
  }

  void set_stop(dJointID hinge, const Spring& spring, double target_rad) const {
    const bool any = timestep_s_ * spring.stiffness + spring.damping > 0.0;
    dJointSetHingeParam(hinge, dParamLoStop, any ? target_rad : -dInfinity);
    dJointSetHingeParam(hinge, dParamHiStop, any ? target_rad : dInfinity);
    if (!any) return;
    const Row row = row_of(spring, timestep_s_);
    dJointSetHingeParam(hinge, dParamStopERP, row.erp);
    dJointSetHingeParam(hinge, dParamStopCFM, row.cfm);
  }

  const RobotModel& model_;
  Spring limit_;
  double timestep_s_;
  std::vector<dBodyID> bodies_;
  std::vector<dJointID> hinges_;
  std::vector<Geom> geoms_;
  std::vector<std::pair<std::size_t, std::size_t>> self_pairs_;
};

}  // namespace trophic::backend::ode
