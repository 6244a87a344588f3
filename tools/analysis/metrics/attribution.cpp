// SPDX-License-Identifier: MIT
// Definitions of attribution.hpp.
#include <tools/analysis/metrics/attribution.hpp>

#include <map>
#include <tools/analysis/metrics/series.hpp>

namespace trophic::analysis {

std::optional<double> attribution_caught(Events events, Species species) {
  Mean share;
  for (const EventRow& row : events) {
    if (row.kind != observe::EventKind::death || row.cause != Cause::caught || row.species != species) continue;
    share.add(row.origin == Origin::inherited ? 1.0 : 0.0);
  }
  return share.value();
}

std::optional<double> attribution_catches(Events events, Species species) {
  Mean share;
  for (const EventRow& row : events) {
    if (row.kind != observe::EventKind::capture || row.species != species) continue;
    share.add(row.origin == Origin::inherited ? 1.0 : 0.0);
  }
  return share.value();
}

std::optional<double> attribution_catchers(Events events, Species species) {
  std::map<IndividualId, Origin> catchers;
  for (const EventRow& row : events) {
    if (row.kind == observe::EventKind::capture && row.species == species) catchers.emplace(row.id, row.origin);
  }
  Mean share;
  for (const auto& [id, origin] : catchers) share.add(origin == Origin::inherited ? 1.0 : 0.0);
  return share.value();
}

std::optional<double> attribution_died(Events events, Species species) {
  Mean share;
  for (const EventRow& row : events) {
    if (row.kind == observe::EventKind::death && row.species == species) share.add(row.origin == Origin::inherited ? 1.0 : 0.0);
  }
  return share.value();
}

std::optional<double> attribution_credited(Events events, const FoodWeb& web, Species hunter) {
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
