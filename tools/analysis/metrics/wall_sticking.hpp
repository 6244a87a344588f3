// SPDX-License-Identifier: MIT
// Sticking to walls: the share of a species that is close to a wall.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <tools/analysis/data/tables.hpp>
#include <tools/analysis/metrics/series.hpp>

namespace trophic::analysis {

/// "Within one unit of distance to any of the four walls" (Sec. "Metrics for system dynamics").
inline constexpr double wall_reach_m = 1.0;

/// At each tick, members of the group within `reach_m` of a wall (or, in an arena without walls, of where its slopes begin, and
/// beyond) over all its members; ticks without a member are left out. `half_side_m`: the flat floor's, Arena::half_side_m.
[[nodiscard]] inline WindowMean wall_sticking(Agents agents, Species species, Group group, double half_side_m,
                                              double reach_m = wall_reach_m, double window_s = 200.0) {
  WindowMean mean{window_s};
  for (const Agents& now : by_tick(agents)) {
    Mean at_walls;
    for (const AgentRow& row : now) {
      if (row.species != species || !belongs(row, group)) continue;
      const double to_wall_m = half_side_m - std::max(std::abs(row.x_m), std::abs(row.y_m));
      at_walls.add(to_wall_m <= reach_m ? 1.0 : 0.0);
    }
    mean.add(now.front().time_s, at_walls.value());
  }
  return mean;
}

/// What robots spread evenly over the floor would give.
[[nodiscard]] inline double wall_share_of_floor(double half_side_m, double reach_m = wall_reach_m) {
  const double inner = std::max(0.0, 1.0 - reach_m / half_side_m);
  return 1.0 - inner * inner;
}

}  // namespace trophic::analysis
