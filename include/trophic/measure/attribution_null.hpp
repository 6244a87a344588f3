// SPDX-License-Identifier: MIT
// What attribution would be if chance alone chose who catches and who is caught.
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <trophic/measure/series.hpp>
#include <trophic/measure/tables.hpp>

namespace trophic::measure {

/// Attribution of a species if each catch of the run, at its moment, had struck or been made by somebody drawn at random among
/// the members then alive. The paper's baseline of 2/3 leaves out that all founders are random and that the groups may differ in
/// how long they live; these do not. Expectations, without random draws.
struct AttributionNull {
  std::optional<double> caught;    ///< for attribution_caught: a random active victim
  std::optional<double> catches;   ///< for attribution_catches: a random hunter
  std::optional<double> catchers;  ///< for attribution_catchers: expected distinct hunters, inherited over all
};

/// None where the species has no catch of that kind. Replays `events`; a catch is skipped where its victim's birth is not there.
[[nodiscard]] inline AttributionNull attribution_null(Events events, Species species) {
  struct Member {
    IndividualId id;
    Species species;
    Origin origin;
    bool active;
    double never_chosen = 1.0;  // probability that no catch has fallen to it, had hunters been drawn at random
  };
  std::map<BodyIndex, Member> alive;
  Mean caught;
  Mean catches;
  double inherited_catchers = 0.0;
  double catchers = 0.0;
  const auto leave = [&](const Member& member) {
    if (member.species != species) return;
    catchers += 1.0 - member.never_chosen;
    if (member.origin == Origin::inherited) inherited_catchers += 1.0 - member.never_chosen;
  };
  const auto inherited_share = [&](auto&& counts) {
    Mean share;
    for (const auto& [body, member] : alive) {
      if (member.species == species && counts(member)) share.add(member.origin == Origin::inherited ? 1.0 : 0.0);
    }
    return share.value();
  };

  for (const EventRow& row : events) {
    switch (row.kind) {
      case observe::EventKind::birth:
        alive.insert_or_assign(row.body, Member{row.id, row.species, row.origin, row.active});
        break;
      case observe::EventKind::activation:
        if (const auto member = alive.find(row.body); member != alive.end()) member->second.active = true;
        break;
      case observe::EventKind::tag_switch:
        break;
      case observe::EventKind::capture: {
        const auto victim = std::ranges::find_if(alive, [&](const auto& m) { return m.second.id == row.victim; });
        if (victim != alive.end() && victim->second.species == species) {
          caught.add(inherited_share([](const Member& member) { return member.active; }));
        }
        if (row.species != species) break;
        catches.add(inherited_share([](const Member&) { return true; }));
        const auto hunters = std::ranges::count_if(alive, [&](const auto& m) { return m.second.species == species; });
        for (auto& [body, member] : alive) {
          if (member.species == species) member.never_chosen *= 1.0 - 1.0 / static_cast<double>(hunters);
        }
        break;
      }
      case observe::EventKind::death:
        if (const auto member = alive.find(row.body); member != alive.end()) {
          leave(member->second);
          alive.erase(member);
        }
        break;
    }
  }
  for (const auto& [body, member] : alive) leave(member);
  return {.caught = caught.value(), .catches = catches.value(), .catchers = share(inherited_catchers, catchers)};
}

}  // namespace trophic::measure
