// SPDX-License-Identifier: MIT
// The released code's captures: predators act in shuffled order, with one catch each, on a list that changes meanwhile.
#pragma once

#include <numeric>
#include <trophic/death/capture/contract.hpp>

namespace trophic::death::capture {

/// Rule (released code): the indices of the list of hunters are shuffled. Each index in turn selects the hunter at that place
/// of the current list, which is in the order of bodies and includes offspring of this tick's catches, so some hunters act twice
/// and some do not act. A hunter of at least min_age catches the closest active victim if that is closer than reach; founders and
/// newborns start too young. Reads: positions, species, activity, ages.   Random draws: number of hunters - 1.
struct CatchClosest {
  static constexpr std::string_view name = "catch_closest";
  static constexpr std::string_view source = "released code";
  /// An offspring enters the list at its body's place, so the acting hunters and their victims depend on the order of bodies.
  static constexpr bool depends_on_order_of_bodies = true;

  struct Params {
    double reach_m = 1.0;
    double min_age_s = 20.0;
    static constexpr auto fields() {
      return std::tuple{field("reach_m", &Params::reach_m, above(0.0), "a victim closer than this is caught"),
                        field("min_age_s", &Params::min_age_s, at_least(0.0), "age below which hunters do not hunt")};
    }
  };
  Params params;

  [[nodiscard]] std::vector<Capture> captures(const View& view, Rng& rng, std::optional<Species> only = {}) const {
    std::vector<bool> caught(view.robots.size(), false);
    std::vector<BodyIndex> list;  // of hunters, in the order of bodies
    for (BodyIndex body = 0; body < view.robots.size(); ++body) {
      const Species species = view.robots[body].species;
      if (species == only.value_or(species) && view.web.hunts(species)) list.push_back(body);
    }
    std::vector<std::size_t> order(list.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    rng.shuffle(std::span{order});

    std::vector<Capture> result;
    for (const std::size_t index : order) {
      const BodyIndex hunter = list[index];
      if (caught[hunter] || !view.passed(view.robots[hunter].age_from_s, params.min_age_s)) continue;
      const Species species = view.robots[hunter].species;
      const auto eats = [&](Species other) { return view.web.eats(species, other); };
      const auto victim = view.closest(
          hunter,
          [&](BodyIndex other) { return view.robots[other].active && !caught[other] && eats(view.robots[other].species); },
          {.within_m = params.reach_m, .among = view.marks(eats, {}, true)});
      if (!victim || view.distance_m(hunter, *victim) >= params.reach_m) continue;
      caught[*victim] = true;
      result.push_back({hunter, *victim});
      const auto place = std::ranges::lower_bound(list, *victim);
      if (place == list.end() || *place != *victim) list.insert(place, *victim);
    }
    return result;
  }
};
static_assert(CaptureRule<CatchClosest>);

}  // namespace trophic::death::capture
