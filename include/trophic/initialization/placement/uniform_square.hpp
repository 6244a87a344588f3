// SPDX-License-Identifier: MIT
// The released code's start: uniform positions in a square, equal headings.
#pragma once

#include <stdexcept>
#include <trophic/initialization/placement/contract.hpp>
#include <trophic/params/params.hpp>

namespace trophic::initialization::placement {

/// Rule: positions are uniform in [-h, h]^2 and may overlap; all robots face the same way. The released code uses h = 9 m and, by
/// an error in the order of quaternion components, turns each root frame by pi; the spider's forward axis is 45 degrees from
/// its root frame's x.   Reads: arena (bounds only).   Random draws: 2 per robot.
struct UniformSquare {
  static constexpr std::string_view name = "uniform_square";
  static constexpr std::string_view source = "released code";

  static constexpr int max_attempts_per_robot = 1000;

  struct Params {
    double half_extent_m = 9.0;
    double heading_rad = -0.75 * std::numbers::pi;
    static constexpr auto fields() {
      return std::tuple{
          field("half_extent_m", &Params::half_extent_m, above(0.0), "bound on the absolute value of both coordinates"),
          field("heading_rad", &Params::heading_rad, any_number(), "initial heading of every robot")};
    }
  };
  Params params;

  [[nodiscard]] std::vector<GroundPose> place(std::size_t robots, const Arena& arena, double radius_m, Rng& rng) const {
    if (params.half_extent_m > arena.half_side_m) {
      throw std::invalid_argument{"rules.placement.half_extent_m = " + number_text(params.half_extent_m) +
                                  ": must be <= " + number_text(arena.half_side_m) + ", the arena's half side"};
    }
    std::vector<GroundPose> placed(robots);
    for (GroundPose& pose : placed) {
      for (int attempt = 0; attempt == 0 || !is_clear(arena, pose, radius_m); ++attempt) {
        if (attempt == max_attempts_per_robot)
          throw std::invalid_argument{"arena " + arena.name + ": leaves no room between its obstacles"};
        pose.x_m = rng.uniform(-params.half_extent_m, params.half_extent_m);
        pose.y_m = rng.uniform(-params.half_extent_m, params.half_extent_m);
      }
      pose.heading_rad = params.heading_rad;
    }
    return placed;
  }
};
static_assert(Placement<UniformSquare>);

}  // namespace trophic::initialization::placement
