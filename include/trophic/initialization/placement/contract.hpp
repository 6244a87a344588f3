// SPDX-License-Identifier: MIT
// The contract of a slot: the initial poses of the bodies.
#pragma once

#include <concepts>
#include <trophic/habitat/arena.hpp>
#include <trophic/support/rng.hpp>
#include <trophic/support/units.hpp>
#include <vector>

#define TROPHIC_SENTENCE_Placement                                                                     \
  "std::vector<GroundPose> place(std::size_t robots, const Arena&, double radius_m, Rng&) const; see " \
  "trophic/initialization/placement/contract.hpp"

namespace trophic::initialization {

/// `place(robots, arena, radius_m, rng)`: returns one ground pose per robot inside the arena; radius_m is the robot's bounding
/// radius. Throws std::invalid_argument if the robots do not fit.
template <class P>
concept Placement = requires(const P policy, std::size_t robots, const Arena& arena, double radius_m, Rng& rng) {
  { policy.place(robots, arena, radius_m, rng) } -> std::same_as<std::vector<GroundPose>>;
};

}  // namespace trophic::initialization
