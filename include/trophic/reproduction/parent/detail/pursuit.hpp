// SPDX-License-Identifier: MIT
// Escapes of prey from predators, and the prey that may be parents; the parent rules that rank prey by escapes share this.
#pragma once

#include <trophic/reproduction/parent/contract.hpp>

namespace trophic::reproduction::parent::detail {

/// The distances that define pursuit and escape.
struct EscapeDistances {
  double near_m = 3.0;
  double far_m = 5.0;
  static constexpr auto fields() {
    using Own = EscapeDistances;
    return std::tuple{field("near_m", &Own::near_m, above(0.0), "distance within which a predator is a pursuer"),
                      field("far_m", &Own::far_m, above(0.0), "distance from its pursuer beyond which a prey has escaped")};
  }
};

/// Updates the living hunters that pursue `self`, by id: a hunter that eats its species pursues it from the moment it comes
/// within `near_m` until it is farther than `far_m`. Calls `escaped(id)` for each hunter that is now farther. Inactive
/// individuals are not pursued.
template <class Escaped>
void update_pursuers(std::vector<IndividualId>& pursuers, BodyIndex self, const EscapeDistances& distances, const View& view,
                     Escaped&& escaped) {
  const Individual& own = view.robots[self];
  if (!own.active) return pursuers.clear();
  const std::vector<BodyIndex> around = view.within(view.poses[self], distances.far_m);
  std::erase_if(pursuers, [&](IndividualId hunter) {
    const auto is_hunter = [&](BodyIndex body) { return view.robots[body].id == hunter; };
    if (std::ranges::any_of(around, is_hunter)) return false;
    if (std::ranges::find(view.robots, hunter, &Individual::id) != view.robots.end()) escaped(hunter);
    return true;
  });
  for (const BodyIndex body : around) {
    const Individual& other = view.robots[body];
    if (!view.web.eats(other.species, own.species) || view.distance_m(self, body) > distances.near_m) continue;
    if (std::ranges::find(pursuers, other.id) == pursuers.end()) pursuers.push_back(other.id);
  }
}

/// Returns whether an individual may be the parent for a vacancy under a rule that ranks prey: it must be active and of the
/// species to which the body goes or, if the rules do not fix that, of a species that the dead individual ate.
[[nodiscard]] inline bool is_candidate(const Individual& one, const Vacancy& vacancy, const View& view) {
  const bool fits =
      vacancy.successor ? one.species == *vacancy.successor : view.web.eats(view.robots[vacancy.body].species, one.species);
  return fits && one.active;
}

/// Returns the candidate with the greatest `rank(body)`, an optional number; among equals, the one closest to the vacant body.
/// Empty if no candidate has a rank.
template <class Rank>
[[nodiscard]] std::optional<Ancestor> highest_ranked(const Vacancy& vacancy, const View& view, Rank&& rank) {
  std::optional<BodyIndex> best;
  for (BodyIndex body = 0; body < view.robots.size(); ++body) {
    if (body == vacancy.body || !is_candidate(view.robots[body], vacancy, view)) continue;
    const auto own = rank(body);
    if (!own) continue;
    const auto is_closer = [&] { return view.distance_m(vacancy.body, body) < view.distance_m(vacancy.body, *best); };
    if (!best || *own > *rank(*best) || (*own == *rank(*best) && is_closer())) best = body;
  }
  return best ? std::optional{view.robots[*best].as_ancestor()} : std::nullopt;
}

}  // namespace trophic::reproduction::parent::detail
