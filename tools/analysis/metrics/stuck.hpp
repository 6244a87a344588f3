// SPDX-License-Identifier: MIT
// How many robots stand still.
#pragma once

#include <cstdint>
#include <optional>
#include <tools/analysis/metrics/series.hpp>
#include <tools/reading/tables.hpp>

namespace trophic::analysis {

/// A robot is stuck that ends less than this far from where it was `stuck_ticks` ticks before.
inline constexpr double stuck_reach_m = 0.05;
inline constexpr std::int64_t stuck_ticks = 5;  ///< 10 s

/// At each tick the share of stuck robots of a species, or of all; ticks without a member or without one `ticks` later are left
/// out. Bodies count, for the species that they belong to at the start: a birth meanwhile does not move them.
[[nodiscard]] WindowMean stuck(Agents agents, std::optional<Species> species, double reach_m = stuck_reach_m,
                               std::int64_t ticks = stuck_ticks, double window_s = 200.0);

}  // namespace trophic::analysis
