// SPDX-License-Identifier: MIT
// Sticking to walls: the share of a species that is close to a wall.
#pragma once

#include <tools/analysis/metrics/series.hpp>
#include <tools/reading/tables.hpp>

namespace trophic::analysis {

/// "Within one unit of distance to any of the four walls" (Sec. "Metrics for system dynamics").
inline constexpr double wall_reach_m = 1.0;

/// At each tick, members of the group within `reach_m` of a wall (or, in an arena without walls, of where its slopes begin, and
/// beyond) over all its members; ticks without a member are left out. `half_side_m`: the flat floor's, Arena::half_side_m.
[[nodiscard]] WindowMean wall_sticking(Agents agents, Species species, Group group, double half_side_m,
                                       double reach_m = wall_reach_m, double window_s = 200.0);

/// The share of robots spread evenly over the floor.
[[nodiscard]] double wall_share_of_floor(double half_side_m, double reach_m = wall_reach_m);

}  // namespace trophic::analysis
