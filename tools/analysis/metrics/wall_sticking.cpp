// SPDX-License-Identifier: MIT
// Definitions of wall_sticking.hpp.
#include <tools/analysis/metrics/wall_sticking.hpp>

#include <algorithm>
#include <cmath>

namespace trophic::analysis {

WindowMean wall_sticking(Agents agents, Species species, Group group, double half_side_m, double reach_m, double window_s) {
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

double wall_share_of_floor(double half_side_m, double reach_m) {
  const double inner = std::max(0.0, 1.0 - reach_m / half_side_m);
  return 1.0 - inner * inner;
}

}  // namespace trophic::analysis
