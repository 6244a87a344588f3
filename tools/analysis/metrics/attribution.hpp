// SPDX-License-Identifier: MIT
// Attribution: how much of what a species does or suffers falls to those who inherited their genome.
#pragma once

#include <optional>
#include <tools/analysis/data/tables.hpp>
#include <trophic/population/food_web.hpp>

namespace trophic::analysis {

/// The baseline that the paper compares both attributions with: the share of newborn that inherit (Sec. "Attribution").
inline constexpr double attribution_paper_baseline = 2.0 / 3.0;

/// Members of `species` that were caught and had inherited, among those caught: Eq. 4 of Sec. "Metrics for system
/// dynamics". Lower is better. None without a catch.
[[nodiscard]] std::optional<double> attribution_caught(Events events, Species species);

/// Catches made by inherited members of `species`, among its catches. Higher is better. None without a catch.
[[nodiscard]] std::optional<double> attribution_catches(Events events, Species species);

/// Inherited members of `species` that ever caught anybody, among its members that did: Eq. 5, as the paper's text says.
[[nodiscard]] std::optional<double> attribution_catchers(Events events, Species species);

/// Inherited members of `species` among its dead of any cause. The authors' log of deaths names no cause, so this is what it
/// gives for prey: sacrificed ones are in it. None without a death.
[[nodiscard]] std::optional<double> attribution_died(Events events, Species species);

/// Deaths of the prey of `hunter` that are put down to an inherited hunter, as the authors' log does it: whoever lives in the
/// body that last caught the dead one's body. A sacrifice, too, has such a killer; a body that was never caught has body 1. This
/// count is the published 0.725 for predators. None without such a death.
[[nodiscard]] std::optional<double> attribution_credited(Events events, const FoodWeb& web, Species hunter);

}  // namespace trophic::analysis
