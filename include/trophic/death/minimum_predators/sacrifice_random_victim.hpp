// SPDX-License-Identifier: MIT
// A predator species with few members gains the body of a prey.
#pragma once

#include <trophic/death/minimum_predators/contract.hpp>

namespace trophic::death::minimum_predators {

/// Rule: for each hunting species with fewer than `below` members, one individual that it eats is chosen uniformly, including
/// inactive newborns, and sacrificed, and its body becomes a hunter's; one per species and tick (Sec. "Prey Death": fewer than 7;
/// the released code: 7 or fewer, which is below 8). Two such species gain two individuals. If the floor forbids the sacrifice of
/// the chosen individual, no other one is chosen.   Reads: species.   Random draws: 1 per sacrifice.
struct SacrificeRandomVictim {
  static constexpr std::string_view name = "sacrifice_random_victim";
  static constexpr std::string_view source = "paper, Sec. \"Prey Death\"";

  struct Params {
    std::size_t below = 7;
    static constexpr auto fields() {
      return std::tuple{field("below", &Params::below, at_least(0), "number of members below which a hunting species gains one")};
    }
  };
  Params params;

  [[nodiscard]] std::vector<Sacrifice> sacrifices(const View& view, Rng& rng) const {
    std::vector<Sacrifice> result;
    for (Species hunter = 0; hunter < view.web.size(); ++hunter) {
      if (!view.web.hunts(hunter) || view.count(hunter) >= params.below) continue;
      std::vector<BodyIndex> victims;
      for (BodyIndex body = 0; body < view.robots.size(); ++body) {
        const bool is_taken = std::ranges::find(result, body, &Sacrifice::victim) != result.end();
        if (!is_taken && view.web.eats(hunter, view.robots[body].species)) victims.push_back(body);
      }
      if (!victims.empty()) result.push_back({.victim = victims[rng.index(victims.size())], .successor = hunter});
    }
    return result;
  }
};
static_assert(MinimumPredators<SacrificeRandomVictim>);

}  // namespace trophic::death::minimum_predators
