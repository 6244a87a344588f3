// SPDX-License-Identifier: MIT
// Random positions and headings without overlaps.
#pragma once

#include <stdexcept>
#include <trophic/initialization/placement/contract.hpp>
#include <trophic/initialization/placement/detail/squares.hpp>
#include <trophic/params/params.hpp>

namespace trophic::initialization::placement {

/// Rule: positions are uniform over the floor, at least one bounding radius from walls and obstacles, and redrawn while closer
/// than two bounding radii to a robot already placed; headings are uniform. The paper has "attributed to one of the available
/// bodies" (Sec. "Initialization") and is silent about their positions and headings. Positions in the released code are also
/// random (UniformSquare).   Reads: arena, radius.   Random draws: 3 per attempt.
struct Scattered {
  static constexpr std::string_view name = "scattered";
  static constexpr std::string_view source = "paper: silent; Sec. \"Initialization\" names no positions";
  static constexpr int max_attempts_per_robot = 1000;

  [[nodiscard]] std::vector<GroundPose> place(std::size_t robots, const Arena& arena, double radius_m, Rng& rng) const {
    const double reach_m = arena.half_side_m - radius_m;
    if (reach_m < 0.0) {
      throw std::invalid_argument{"robot bounding radius = " + number_text(radius_m) +
                                  " m: must be <= " + number_text(arena.half_side_m) + ", the arena's half side"};
    }
    std::vector<GroundPose> placed;
    detail::Squares squares{reach_m, radius_m, robots};
    while (placed.size() < robots) {
      if (!place_one(placed, squares, arena, radius_m, rng)) {
        throw std::invalid_argument{"ecology.robots = " + std::to_string(robots) + ": must be <= about " +
                                    std::to_string(placed.size()) + " to stand apart in a square of half side " +
                                    number_text(arena.half_side_m) + " m"};
      }
    }
    return placed;
  }

 private:
  static bool place_one(std::vector<GroundPose>& placed, detail::Squares& squares, const Arena& arena, double radius_m,
                        Rng& rng) {
    const double reach_m = arena.half_side_m - radius_m;
    for (int attempt = 0; attempt < max_attempts_per_robot; ++attempt) {
      GroundPose pose;
      pose.x_m = rng.uniform(-reach_m, reach_m);
      pose.y_m = rng.uniform(-reach_m, reach_m);
      pose.heading_rad = rng.uniform(-std::numbers::pi, std::numbers::pi);
      if (!is_clear(arena, pose, radius_m)) continue;
      if (squares.all_near(pose, [&](const GroundPose& other) { return distance_m(other, pose) >= 2.0 * radius_m; })) {
        placed.push_back(pose);
        squares.add(pose);
        return true;
      }
    }
    return false;
  }
};
static_assert(Placement<Scattered>);

}  // namespace trophic::initialization::placement
