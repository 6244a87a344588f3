// SPDX-License-Identifier: MIT
// The contract of a placement rule: where the bodies stand when a run starts.
#pragma once

#include <concepts>
#include <cstddef>
#include <trophic/arena.hpp>
#include <trophic/rng.hpp>
#include <trophic/units.hpp>
#include <vector>

namespace trophic::placement {

/// `place(robots, arena, radius_m, rng)`: one ground pose per robot inside the arena; radius_m is the robot's bounding
/// radius. Throws std::invalid_argument if so many do not fit.
template <class P>
concept Placement = requires(const P policy, std::size_t robots, const Arena& arena, double radius_m, Rng& rng) {
  { policy.place(robots, arena, radius_m, rng) } -> std::same_as<std::vector<GroundPose>>;
};

}  // namespace trophic::placement
