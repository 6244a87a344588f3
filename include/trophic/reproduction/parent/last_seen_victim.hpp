// SPDX-License-Identifier: MIT
// The prey that the dying predator last perceived as closest reproduces, however long ago that was.
#pragma once

#include <trophic/reproduction/parent/contract.hpp>

namespace trophic::reproduction::parent {

/// Rule (released code): the parent is the last individual that the dying hunter's body perceived as closest among those it
/// eats, at any distance, dead or alive. The memory changes only when another body becomes the closest: a birth in the
/// remembered body is not noticed. It outlives births in the hunter's body and is cleared only by a catch.   Reads: its own
/// state.   Random draws: 0.
struct LastSeenVictim {
  static constexpr std::string_view name = "last_seen_victim";
  static constexpr std::string_view source = "released code";

  /// The state of a body.
  struct State {
    std::optional<BodyIndex> body;   ///< the last body perceived as closest whose occupant this body's species eats
    std::optional<Ancestor> victim;  ///< the occupant of that body when it became the closest
    static constexpr auto fields() { return std::tuple{field("body", &State::body), field("victim", &State::victim)}; }
  };
  [[nodiscard]] State born(const Individual&, const State*, const State& body) const { return body; }
  void on_catch(State& own, BodyIndex, BodyIndex, const View&) const { own = {}; }
  void on_sighting(State& own, BodyIndex self, const std::optional<Sighting>& sighting, const View& view) const {
    if (!sighting || own.body == sighting->adversary) return;
    const Individual& adversary = view.robots[sighting->adversary];
    if (view.web.eats(view.robots[self].species, adversary.species)) own = {sighting->adversary, adversary.as_ancestor()};
  }

  [[nodiscard]] std::optional<Ancestor> parent(const Vacancy& vacancy, const View&, Rng&, std::span<const State> states) const {
    return states[vacancy.body].victim;
  }
};
static_assert(Parent<LastSeenVictim>);

}  // namespace trophic::reproduction::parent
