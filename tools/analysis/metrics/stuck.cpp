// SPDX-License-Identifier: MIT
// Definitions of stuck.hpp.
#include <tools/analysis/metrics/stuck.hpp>

#include <cmath>

namespace trophic::analysis {

WindowMean stuck(Agents agents, std::optional<Species> species, double reach_m, std::int64_t ticks, double window_s) {
  WindowMean mean{window_s};
  for (const auto& [now, later] : stretches(agents, ticks)) {
    if (later.empty()) continue;
    const Moment end{later};
    Mean share;
    for (const AgentRow& from : now) {
      const AgentRow* to = end.find_body(from.body);
      if (to == nullptr || (species && from.species != *species)) continue;
      share.add(std::hypot(to->x_m - from.x_m, to->y_m - from.y_m) < reach_m ? 1.0 : 0.0);
    }
    mean.add(now.front().time_s, share.value());
  }
  return mean;
}

}  // namespace trophic::analysis
