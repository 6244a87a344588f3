// SPDX-License-Identifier: MIT
// How many live, how hungry they are, how they die.
#pragma once

#include <cstddef>
#include <optional>
#include <tools/analysis/metrics/series.hpp>
#include <tools/reading/tables.hpp>

namespace trophic::analysis {

/// Members of a group at each tick.
[[nodiscard]] WindowMean population_size(Agents agents, Species species, Group group, double window_s = 200.0);

/// Share of the ticks at which a species has exactly `members` members; 0 or 1 at each tick.
[[nodiscard]] WindowMean ticks_at(Agents agents, Species species, std::size_t members, double window_s = 200.0);

/// Ticks since birth or last catch, averaged over the members of a species; ticks without a member are left out. Empty for a
/// species without prey.
[[nodiscard]] WindowMean hunger(Agents agents, Species species, double window_s = 200.0);

/// Deaths of members of a species, of one cause or of any.
[[nodiscard]] std::size_t deaths(Events events, Species species, std::optional<Cause> cause = {});

/// Deaths in each window (k w, (k + 1) w] up to `until_s`; a death at time 0 belongs to the first.
[[nodiscard]] Series deaths_per_window(Events events, Species species, std::optional<Cause> cause, double until_s,
                                       double window_s = 200.0);

}  // namespace trophic::analysis
