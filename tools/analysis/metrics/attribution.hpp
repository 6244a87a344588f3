// SPDX-License-Identifier: MIT
// Attribution: how much of what a species does or suffers falls to those who inherited their genome.
#pragma once

#include <tools/reading/tables.hpp>
#include <trophic/population/food_web.hpp>

namespace trophic::analysis {

/// The baseline that the paper compares both attributions with: the share of newborn that inherit (Sec. "Attribution").
inline constexpr double attribution_paper_baseline = 2.0 / 3.0;

/// Members of `species` that were caught and had inherited, among those caught: Eq. 4 of Sec. "Metrics for system
/// dynamics". Lower is better. None without a catch.
[[nodiscard]] std::optional<double> attribution_caught(Events events, Species species);

/// Catches made by inherited members of `species`, among its catches. Higher is better. None without a catch.
[[nodiscard]] std::optional<double> attribution_catches(Events events, Species species);

/// Share of inherited individuals among the members of `species` that ever caught one: Eq. 5, as the paper's text says.
[[nodiscard]] std::optional<double> attribution_catchers(Events events, Species species);

/// Inherited members of `species` among its dead of any cause. The authors' log of deaths names no cause, so this is what it
/// gives for prey: sacrificed ones are in it. None without a death.
[[nodiscard]] std::optional<double> attribution_died(Events events, Species species);

/// Share of the deaths of `hunter`'s prey that are attributed to an inherited hunter as in the authors' log: to the occupant of
/// the body that last caught the prey's body. A sacrifice has such a killer too; a body that was never caught has body 1. The
/// published 0.725 for predators is this share. `nullopt` without such a death.
[[nodiscard]] std::optional<double> attribution_credited(Events events, const FoodWeb& web, Species hunter);

}  // namespace trophic::analysis
