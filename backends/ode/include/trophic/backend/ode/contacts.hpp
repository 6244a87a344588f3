// SPDX-License-Identifier: MIT
// Contact joints between boxes and with the ground.
#pragma once

#include <ode/ode.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <trophic/backend/ode/compliance.hpp>
#include <trophic/backend/ode/params.hpp>

namespace trophic::backend::ode {

/// Normal force and friction of surfaces. The normal force is a spring and damper per contact point. Friction: the force along
/// the surface is a damper (ODE's slip), so that a loaded contact creeps a little, as MuJoCo's does, up to the friction limit.
///
/// The limit: with dContactApprox1, ODE bounds the force along each of two directions by mu times the actual normal force, a
/// square around Coulomb's circle of radius mu N. MuJoCo's pyramidal cone allows |f1| + |f2| <= mu N, a square inside the
/// circle with its corners on the directions. Both squares are equal if ODE's directions lie at 45 degrees to MuJoCo's and its
/// coefficient is mu / sqrt(2), as set here.
class ContactLaw {
 public:
  ContactLaw(const Params& params, double timestep_s) {
    const Row row = row_of({.stiffness = params.contact_stiffness_N_m, .damping = params.contact_damping_N_s_m}, timestep_s);
    surface_.mode = dContactSoftERP | dContactSoftCFM | dContactSlip1 | dContactSlip2 | dContactApprox1 | dContactFDir1;
    surface_.soft_erp = row.erp;
    surface_.soft_cfm = row.cfm;
    surface_.slip1 = surface_.slip2 = 1.0 / params.friction_damping_N_s_m;
  }

  /// Adds a joint to `group` for each contact point of the geoms.
  void touch(dWorldID world, dJointGroupID group, dGeomID a, dGeomID b, double friction) const {
    constexpr int most_points = 8;
    std::array<dContactGeom, most_points> points{};
    const int found = dCollide(a, b, most_points, points.data(), sizeof(dContactGeom));
    for (int i = 0; i < found; ++i) {
      dContact contact{};
      contact.surface = surface_;
      contact.surface.mu = friction / std::numbers::sqrt2;
      contact.geom = points[static_cast<std::size_t>(i)];
      set_direction(contact);
      const dJointID joint = dJointCreateContact(world, group, &contact);
      dJointAttach(joint, dGeomGetBody(contact.geom.g1), dGeomGetBody(contact.geom.g2));
    }
  }

 private:
  /// MuJoCo's first direction is the part of y (of z, for a normal within 60 degrees of y) along the surface; its second is
  /// normal x first.
  static void set_direction(dContact& contact) {
    const Eigen::Vector3d normal = Eigen::Map<const Eigen::Vector3d>{contact.geom.normal};
    const Eigen::Vector3d guide = std::abs(normal.y()) < 0.5 ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitZ();
    const Eigen::Vector3d first = (guide - normal.dot(guide) * normal).normalized();
    Eigen::Map<Eigen::Vector3d>{contact.fdir1} = (first + normal.cross(first)) / std::numbers::sqrt2;
  }

  dSurfaceParameters surface_{};
};

}  // namespace trophic::backend::ode
