// SPDX-License-Identifier: MIT
// Builds the engine-neutral robot from a module tree: links, inertias, hinges, neighbours, size.
#pragma once

#include <numbers>
#include <optional>
#include <trophic/habitat/body/module.hpp>
#include <trophic/habitat/physics.hpp>
#include <trophic/habitat/robot_model.hpp>

namespace trophic::body {

/// A robot as described by its file.
struct Design {
  std::string name;
  std::string gait;  ///< name or path of its default gait
  ModuleTree modules;
  double forward_deg = 0.0;
  double friction = 1.0;
  double hinge_range_rad = 1.047197551;  ///< 60 degrees
  std::optional<double>
      root_density_kg_m3;  ///< if set, boxes of the root link weigh volume * density instead of their part's mass
  Servo servo;
  MeasuredWalk walk;
  PartMasses part_mass_kg;

  static constexpr auto fields() {
    return std::tuple{field("forward_deg", &Design::forward_deg, between(-180.0, 180.0)),
                      field("friction", &Design::friction, between(0.0, most_friction)),
                      field("hinge_range_rad", &Design::hinge_range_rad, above_to(0.0, std::numbers::pi)),
                      field("walk", &Design::walk), field("part_mass_kg", &Design::part_mass_kg)};
  }
};

/// Builds the robot of a design. Modules that are not separated by a hinge become one link; every part is a uniform box; hinges
/// and links are numbered depth first in face order. Hinges i and j are neighbours if at most two attachments lie between them.
/// The bounding radius is the sum of the hinge distances along the longest chain and the reach of its last box. Throws
/// std::invalid_argument.
[[nodiscard]] RobotModel build(const Design& design);

}  // namespace trophic::body

#if TROPHIC_HEADER_ONLY
#include <trophic/habitat/body/build.ipp>
#endif
