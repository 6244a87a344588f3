// SPDX-License-Identifier: MIT
// Births from an individual and the mate that it chooses among those near.
#pragma once

#include <algorithm>
#include <trophic/params/group.hpp>
#include <trophic/reproduction/recruitment/contract.hpp>
#include <trophic/reproduction/recruitment/mate/contract.hpp>
#include <trophic/support/joined_text.hpp>

namespace trophic::reproduction::recruitment {

/// Rule: an active individual with at least `birth` energy chooses a mate among the active individuals of its species at most
/// `range` away, and has an offspring with it, next to itself. The probability of each possible mate is proportional to the
/// product of its weights by the Preferences (mate/); without preferences it is the same for all. If all weights are 0, there is
/// no birth. The oldest chooses first, and each individual is a parent at most once a tick. If `both_pay`, the mate needs `birth`
/// too, and each gives the `share` of the poorer one's energy; otherwise the individual alone gives the `share` of its energy.
/// The dead are not replaced. `spare_bodies` start without an individual. All parameters are free.   Reads: positions, energies,
/// activity, and what the Preferences read.   Random draws: 1 per birth.
template <MatePreference... Preferences>
struct WithMate {
  struct Names {
    static constexpr std::array<std::string_view, sizeof...(Preferences)> names{Preferences::name...};
    static constexpr std::array<std::string_view, 1 + sizeof...(Preferences)> words{"with_mate", Preferences::name...};
    static constexpr std::string_view separator = "_";
  };
  static constexpr std::string_view name = JoinedText<Names>::view;
  static constexpr std::string_view source = "not in the paper";

  struct Params {
    std::size_t spare_bodies = 0;
    double birth_J = 60.0;
    double share = 0.3;
    double range_m = 3.0;
    bool both_pay = true;
    GroupOf<Names, ParamsOf<Preferences>...> mate = {};
    static constexpr auto fields() {
      return std::tuple{
          field("spare_bodies", &Params::spare_bodies, at_least(0), "number of bodies without an individual at the start")
              .read_at_start(),
          field("birth_J", &Params::birth_J, above(0.0), "energy at which an individual reproduces"),
          field("share", &Params::share, above_to(0.0, 1.0), "share of the energy that each paying parent gives"),
          field("range_m", &Params::range_m, at_least(0.0), "largest distance between the parents"),
          field("both_pay", &Params::both_pay, "whether both parents give energy; false: only the one that chooses"),
          field("mate", &Params::mate)};
    }
  };
  Params params;

  [[nodiscard]] std::size_t spare_bodies() const { return params.spare_bodies; }
  [[nodiscard]] bool leaves_spare(const Vacancy&, const View&) const { return true; }
  [[nodiscard]] std::vector<Recruit> recruits(const View& view, Rng& rng) const {
    const auto id_of = [&](BodyIndex body) { return view.robots[body].id; };
    std::vector<BodyIndex> free;  // to be a parent in this tick, the oldest first
    for (BodyIndex body = 0; body < view.robots.size(); ++body)
      if (view.robots[body].lives() && view.robots[body].active) free.push_back(body);
    std::ranges::sort(free, {}, id_of);
    std::vector<bool> is_parent(view.robots.size());
    std::vector<Recruit> births;
    for (const BodyIndex self : free) {
      const Individual& one = view.robots[self];
      if (is_parent[self] || one.energy_J < params.birth_J) continue;
      std::vector<BodyIndex> mates = view.within(view.poses[self], params.range_m);
      std::erase_if(mates, [&](BodyIndex other) {
        const Individual& two = view.robots[other];
        const bool can_pay = !params.both_pay || two.energy_J >= params.birth_J;
        return other == self || is_parent[other] || two.species != one.species || !two.active || !can_pay;
      });
      std::ranges::sort(mates, {}, id_of);
      std::vector<double> weights;  // of all up to each
      for (const BodyIndex other : mates) weights.push_back((weights.empty() ? 0.0 : weights.back()) + weight(self, other, view));
      if (weights.empty() || !(weights.back() > 0.0)) continue;
      const double drawn = rng.uniform(0.0, weights.back());
      const BodyIndex mate = mates[static_cast<std::size_t>(std::ranges::upper_bound(weights, drawn) - weights.begin())];
      const Individual& other = view.robots[mate];
      const double gift_J = params.both_pay ? 2.0 * std::min(one.energy_J, other.energy_J) : one.energy_J;
      is_parent[self] = is_parent[mate] = true;
      births.push_back({.species = one.species,
                        .parents = {one.as_ancestor(), other.as_ancestor()},
                        .endowment_J = params.share * gift_J,
                        .first_pays = !params.both_pay});
    }
    return births;
  }

 private:
  [[nodiscard]] double weight(BodyIndex self, BodyIndex other, const View& view) const {
    return [&]<std::size_t... place>(std::index_sequence<place...>) {
      return (1.0 * ... * make_policy<Preferences>(params.mate.template get<place>()).weight(self, other, view));
    }
    (std::index_sequence_for<Preferences...>{});
  }
};
static_assert(Recruitment<WithMate<>>);

}  // namespace trophic::reproduction::recruitment
