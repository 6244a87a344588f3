// SPDX-License-Identifier: MIT
// Definitions of demography.hpp.
#include <tools/analysis/metrics/demography.hpp>

#include <algorithm>
#include <cmath>

namespace trophic::analysis {

WindowMean population_size(Agents agents, Species species, Group group, double window_s) {
  WindowMean mean{window_s};
  for (const Agents& now : by_tick(agents)) {
    const auto members =
        std::ranges::count_if(now, [&](const AgentRow& row) { return row.species == species && belongs(row, group); });
    mean.add(now.front().time_s, static_cast<double>(members));
  }
  return mean;
}

WindowMean ticks_at(Agents agents, Species species, std::size_t members, double window_s) {
  WindowMean mean{window_s};
  for (const Agents& now : by_tick(agents)) {
    const auto alive = static_cast<std::size_t>(std::ranges::count(now, species, &AgentRow::species));
    mean.add(now.front().time_s, alive == members ? 1.0 : 0.0);
  }
  return mean;
}

WindowMean hunger(Agents agents, Species species, double window_s) {
  WindowMean mean{window_s};
  for (const Agents& now : by_tick(agents)) {
    Mean ticks;
    for (const AgentRow& row : now) {
      if (row.species == species && row.hunger_ticks) ticks.add(static_cast<double>(*row.hunger_ticks));
    }
    mean.add(now.front().time_s, ticks.value());
  }
  return mean;
}

std::size_t deaths(Events events, Species species, std::optional<Cause> cause) {
  return static_cast<std::size_t>(std::ranges::count_if(events, [&](const EventRow& row) {
    return row.kind == observe::EventKind::death && row.species == species && (!cause || row.cause == cause);
  }));
}

Series deaths_per_window(Events events, Species species, std::optional<Cause> cause, double until_s, double window_s) {
  Series series;
  for (std::size_t window = 1; window_s * static_cast<double>(window) < until_s + window_s; ++window) {
    series.push_back({window_s * static_cast<double>(window), 0.0});
  }
  for (const EventRow& row : events) {
    const double window = std::max(0.0, std::ceil(row.time_s / window_s) - 1.0);
    const bool counts = row.kind == observe::EventKind::death && row.species == species && (!cause || row.cause == cause);
    if (counts && window < static_cast<double>(series.size())) *series[static_cast<std::size_t>(window)].value += 1.0;
  }
  return series;
}

}  // namespace trophic::analysis
