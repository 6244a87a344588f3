// SPDX-License-Identifier: MIT
// Attribution: how much of what a species does or suffers falls to those who inherited their genome.
#pragma once

#include <map>
#include <optional>
#include <trophic/measure/series.hpp>
#include <trophic/measure/tables.hpp>

namespace trophic::measure {

/// The baseline that the paper compares both attributions with: the share of newborn that inherit (Sec. "Attribution").
inline constexpr double attribution_paper_baseline = 2.0 / 3.0;

/// Members of `species` that were caught and had inherited, among those caught: Eq. "sucprey" of Sec. "Metrics for system
/// dynamics". Lower is better. None without a catch.
[[nodiscard]] inline std::optional<double> attribution_caught(Events events, Species species) {
  Mean share;
  for (const EventRow& row : events) {
    if (row.kind != observe::EventKind::death || row.cause != Cause::caught || row.species != species) continue;
    share.add(row.origin == Origin::inherited ? 1.0 : 0.0);
  }
  return share.value();
}

/// Catches made by inherited members of `species`, among its catches: what the paper's published number for predators counts.
/// Higher is better. None without a catch.
[[nodiscard]] inline std::optional<double> attribution_catches(Events events, Species species) {
  Mean share;
  for (const EventRow& row : events) {
    if (row.kind != observe::EventKind::capture || row.species != species) continue;
    share.add(row.origin == Origin::inherited ? 1.0 : 0.0);
  }
  return share.value();
}

/// Inherited members of `species` that ever caught anybody, among its members that did: Eq. "sucpred", as the paper's text says.
[[nodiscard]] inline std::optional<double> attribution_catchers(Events events, Species species) {
  std::map<IndividualId, Origin> catchers;
  for (const EventRow& row : events) {
    if (row.kind == observe::EventKind::capture && row.species == species) catchers.emplace(row.id, row.origin);
  }
  Mean share;
  for (const auto& [id, origin] : catchers) share.add(origin == Origin::inherited ? 1.0 : 0.0);
  return share.value();
}

}  // namespace trophic::measure
