// SPDX-License-Identifier: MIT
// Prey reproduce by escaping.
#pragma once

#include <trophic/reproduction/parent/detail/pursuit.hpp>
#include <trophic/reproduction/recruitment/contract.hpp>

namespace trophic::reproduction::recruitment {

/// Rule: an active prey that has escaped `escapes` times since its birth or its last offspring has an offspring next to it. If
/// spare bodies are scarce, the prey with the most escapes comes first, and among equals the oldest. After starvation or
/// senescence a body stays spare unless there are `spare_bodies` already; after a catch or a sacrifice it is filled at once. An
/// escape: a living predator that was within distances.near_m of the active prey is now farther than distances.far_m. Escapes
/// thus add prey and starvation removes predators, by at most `spare_bodies` in total. All its parameters are free.   Reads:
/// positions, species, activity, its own state.   Random draws: 0.
struct AfterEscapes {
  static constexpr std::string_view name = "after_escapes";
  static constexpr std::string_view source = "not in the paper; its conclusion asks for an explicit criterion";
  using NamesOneParent = AfterEscapes;

  struct Params {
    std::size_t spare_bodies = 6;
    std::int64_t escapes = 1;
    parent::detail::EscapeDistances distances{};
    static constexpr auto fields() {
      return std::tuple{field("spare_bodies", &Params::spare_bodies, at_least(0),
                              "number of bodies without an individual at the start, which is also the most at any time"),
                        field("escapes", &Params::escapes, at_least(1), "number of escapes before each offspring"),
                        field("distances", &Params::distances)};
    }
  };
  Params params;

  /// Per individual.
  struct State {
    std::vector<IndividualId> pursuers;  ///< predators that came near and are not yet far
    std::int64_t escapes = 0;            ///< since birth or the last offspring
    static constexpr auto fields() { return std::tuple{field("pursuers", &State::pursuers), field("escapes", &State::escapes)}; }
  };
  [[nodiscard]] State born(const Individual&, const State*, const State&) const { return {}; }
  void on_walk(State& own, BodyIndex self, double, const View& view) const {
    parent::detail::update_pursuers(own.pursuers, self, params.distances, view, [&](IndividualId) { ++own.escapes; });
  }
  void on_offspring(State& own, BodyIndex, BodyIndex, const View&) const { own.escapes = 0; }

  [[nodiscard]] std::size_t spare_bodies() const { return params.spare_bodies; }
  [[nodiscard]] bool leaves_spare(const Vacancy& vacancy, const View& view) const {
    if (vacancy.cause != Cause::starved && vacancy.cause != Cause::senescence) return false;
    const auto living = static_cast<std::size_t>(std::ranges::count_if(view.robots, &Individual::lives));
    return view.robots.size() - living < params.spare_bodies;
  }

  [[nodiscard]] std::vector<Recruit> recruits(const View& view, Rng&, std::span<const State> states) const {
    std::vector<BodyIndex> parents;
    std::size_t spare = 0;
    for (BodyIndex body = 0; body < view.robots.size(); ++body) {
      if (!view.robots[body].lives()) {
        ++spare;
      } else if (view.robots[body].active && states[body].escapes >= params.escapes) {
        parents.push_back(body);
      }
    }
    std::ranges::sort(parents, [&](BodyIndex a, BodyIndex b) {
      return states[a].escapes != states[b].escapes ? states[a].escapes > states[b].escapes
                                                    : view.robots[a].id < view.robots[b].id;
    });
    std::vector<Recruit> births;
    parents.resize(std::min(parents.size(), spare));
    for (const BodyIndex one : parents)
      births.push_back({.species = view.robots[one].species, .parents = {view.robots[one].as_ancestor()}});
    return births;
  }
};
static_assert(Recruitment<AfterEscapes>);

}  // namespace trophic::reproduction::recruitment
