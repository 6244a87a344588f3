// SPDX-License-Identifier: MIT
// How many live, how hungry they are, how they die.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <tools/analysis/data/tables.hpp>
#include <tools/analysis/metrics/series.hpp>

namespace trophic::analysis {

/// Members of a group at each tick.
[[nodiscard]] inline WindowMean population_size(Agents agents, Species species, Group group, double window_s = 200.0) {
  WindowMean mean{window_s};
  for (const Agents& now : by_tick(agents)) {
    const auto members =
        std::ranges::count_if(now, [&](const AgentRow& row) { return row.species == species && belongs(row, group); });
    mean.add(now.front().time_s, static_cast<double>(members));
  }
  return mean;
}

/// Share of the ticks at which a species has exactly `members` members; 0 or 1 at each tick.
[[nodiscard]] inline WindowMean ticks_at(Agents agents, Species species, std::size_t members, double window_s = 200.0) {
  WindowMean mean{window_s};
  for (const Agents& now : by_tick(agents)) {
    const auto alive = static_cast<std::size_t>(std::ranges::count(now, species, &AgentRow::species));
    mean.add(now.front().time_s, alive == members ? 1.0 : 0.0);
  }
  return mean;
}

/// Ticks since birth or last catch, averaged over the members of a species; ticks without a member are left out. Empty for a
/// species that hunts nobody.
[[nodiscard]] inline WindowMean hunger(Agents agents, Species species, double window_s = 200.0) {
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

/// Deaths of members of a species, of one cause or of any.
[[nodiscard]] inline std::size_t deaths(Events events, Species species, std::optional<Cause> cause = {}) {
  return static_cast<std::size_t>(std::ranges::count_if(events, [&](const EventRow& row) {
    return row.kind == observe::EventKind::death && row.species == species && (!cause || row.cause == cause);
  }));
}

/// Deaths in each window (k w, (k + 1) w] up to `until_s`; a death at time 0 belongs to the first.
[[nodiscard]] inline Series deaths_per_window(Events events, Species species, std::optional<Cause> cause, double until_s,
                                              double window_s = 200.0) {
  Series series;
  for (double end_s = window_s; end_s < until_s + window_s; end_s += window_s) {
    const bool first = series.empty();
    const auto inside = std::ranges::count_if(events, [&](const EventRow& row) {
      return row.kind == observe::EventKind::death && row.species == species && (!cause || row.cause == cause) &&
             (first || row.time_s > end_s - window_s) && row.time_s <= end_s;
    });
    series.push_back({end_s, static_cast<double>(inside)});
  }
  return series;
}

}  // namespace trophic::analysis
