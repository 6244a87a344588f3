// SPDX-License-Identifier: MIT
// Conditions that a body must satisfy before an individual is born with it.
#pragma once

#include <cstddef>
#include <optional>
#include <trophic/habitat/body/module.hpp>
#include <trophic/params/params.hpp>

namespace trophic {
struct RobotModel;
}

namespace trophic::body {

/// Bounds on the parts of a body.
struct Limits {
  std::size_t most_modules = 20;
  std::size_t fewest_hinges = 1;
  std::size_t most_hinges = 10;

  static constexpr auto fields() {
    return std::tuple{field("most_modules", &Limits::most_modules, between(1.0, 100.0),
                            "largest number of modules in a body, including its core"),
                      field("fewest_hinges", &Limits::fewest_hinges, between(0.0, 100.0), "smallest number of hinges in a body"),
                      field("most_hinges", &Limits::most_hinges, between(0.0, 100.0), "largest number of hinges in a body")};
  }
};

/// The names of two links with boxes that overlap at rest (all angles 0), as "A and B"; empty if none do. Links joined by a hinge
/// are ignored, because engines also let them overlap. The grid of modules cannot detect overlaps, because parts are not as long
/// as their cells.
[[nodiscard]] std::string overlapping_links(const RobotModel& robot);

/// Whether some hinge is on the left or right side of the robot's axis; only such hinges can be treated differently by a Steering
/// rule.
[[nodiscard]] bool has_sides(const RobotModel& robot);

/// Why a body is not viable, e.g. "12 hinges: must be <= 10"; empty if it is viable. The checks, in order: number of modules,
/// numbers of hinges, a hinge on the left or the right (if hinges are required at all), overlap of boxes.
[[nodiscard]] std::optional<std::string> refusal(const ModuleTree& tree, const RobotModel& robot, const Limits& limits);

}  // namespace trophic::body

#if TROPHIC_HEADER_ONLY
#include <trophic/habitat/body/limits.ipp>
#endif
