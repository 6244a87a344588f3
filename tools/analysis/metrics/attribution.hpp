// SPDX-License-Identifier: MIT
// Attribution: how much of what a species does or suffers falls to those who inherited their genome.
#pragma once

#include <map>
#include <optional>
#include <tools/analysis/data/tables.hpp>
#include <tools/analysis/metrics/series.hpp>
#include <trophic/population/food_web.hpp>

namespace trophic::analysis {

/// The baseline that the paper compares both attributions with: the share of newborn that inherit (Sec. "Attribution").
inline constexpr double attribution_paper_baseline = 2.0 / 3.0;

/// Members of `species` that were caught and had inherited, among those caught: Eq. 4 of Sec. "Metrics for system
/// dynamics". Lower is better. None without a catch.
[[nodiscard]] inline std::optional<double> attribution_caught(Events events, Species species) {
  Mean share;
  for (const EventRow& row : events) {
    if (row.kind != observe::EventKind::death || row.cause != Cause::caught || row.species != species) continue;
    share.add(row.origin == Origin::inherited ? 1.0 : 0.0);
  }
  return share.value();
}

/// Catches made by inherited members of `species`, among its catches. Higher is better. None without a catch.
[[nodiscard]] inline std::optional<double> attribution_catches(Events events, Species species) {
  Mean share;
  for (const EventRow& row : events) {
    if (row.kind != observe::EventKind::capture || row.species != species) continue;
    share.add(row.origin == Origin::inherited ? 1.0 : 0.0);
  }
  return share.value();
}

/// Inherited members of `species` that ever caught anybody, among its members that did: Eq. 5, as the paper's text says.
[[nodiscard]] inline std::optional<double> attribution_catchers(Events events, Species species) {
  std::map<IndividualId, Origin> catchers;
  for (const EventRow& row : events) {
    if (row.kind == observe::EventKind::capture && row.species == species) catchers.emplace(row.id, row.origin);
  }
  Mean share;
  for (const auto& [id, origin] : catchers) share.add(origin == Origin::inherited ? 1.0 : 0.0);
  return share.value();
}

/// Inherited members of `species` among its dead of any cause. The authors' log of deaths names no cause, so this is what it
/// gives for prey: sacrificed ones are in it. None without a death.
[[nodiscard]] inline std::optional<double> attribution_died(Events events, Species species) {
  Mean share;
  for (const EventRow& row : events) {
    if (row.kind == observe::EventKind::death && row.species == species) share.add(row.origin == Origin::inherited ? 1.0 : 0.0);
  }
  return share.value();
}

/// Deaths of the prey of `hunter` that are put down to an inherited hunter, as the authors' log does it: whoever lives in the
/// body that last caught the dead one's body. A sacrifice, too, has such a killer; a body that was never caught has body 1. This
/// count is the published 0.725 for predators. None without such a death.
[[nodiscard]] inline std::optional<double> attribution_credited(Events events, const FoodWeb& web, Species hunter) {
  std::map<BodyIndex, Origin> occupant;
  std::map<IndividualId, BodyIndex> home;
  std::map<BodyIndex, BodyIndex> last_killer;
  Mean share;
  for (const EventRow& row : events) {
    if (row.kind == observe::EventKind::birth) {
      occupant.insert_or_assign(row.body, row.origin);
      home.insert_or_assign(row.id, row.body);
    } else if (row.kind == observe::EventKind::capture && row.victim && home.contains(*row.victim)) {
      last_killer.insert_or_assign(home.at(*row.victim), row.body);
    } else if (row.kind == observe::EventKind::death && web.eats(hunter, row.species)) {
      const auto killer = last_killer.find(row.body);
      const auto credited = occupant.find(killer == last_killer.end() ? BodyIndex{1} : killer->second);
      if (credited != occupant.end()) share.add(credited->second == Origin::inherited ? 1.0 : 0.0);
    }
  }
  return share.value();
}

}  // namespace trophic::analysis
