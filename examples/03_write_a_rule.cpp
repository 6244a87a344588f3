// SPDX-License-Identifier: MIT
// A new rule: the hungrier a predator, the farther it reaches. If two reach the same prey, the first in order catches it.
#include <iostream>
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/observe/progress.hpp>
#include <trophic/rules/paper.hpp>

struct HungryReach {
  static constexpr std::string_view name = "hungry_reach";
  struct Params {
    double reach_per_tick_m = 0.05;  ///< > 0
    static constexpr auto fields() {
      return std::tuple{trophic::field("reach_per_tick_m", &Params::reach_per_tick_m, trophic::above(0.0),
                                       "additional reach per tick of hunger")};
    }
  };
  Params params;

  std::vector<trophic::death::Capture> captures(const trophic::View& view, trophic::Rng&) const {
    std::vector<trophic::death::Capture> captures;
    std::vector<bool> caught(view.robots.size(), false);
    for (trophic::BodyIndex hunter = 0; hunter < view.robots.size(); ++hunter) {
      const trophic::Individual& self = view.robots[hunter];
      const double reach_m = params.reach_per_tick_m * static_cast<double>(view.hunger_ticks(self));
      const auto victim = view.closest(
          hunter, [&](const trophic::Individual& other) { return other.active && view.web.eats(self.species, other.species); });
      if (!victim || caught[*victim] || view.distance_m(hunter, *victim) > reach_m) continue;
      caught[*victim] = true;
      captures.push_back({hunter, *victim});
    }
    return captures;
  }
};

int main() {
  using Rules = trophic::with_capture<trophic::rules::Paper, HungryReach>;
  trophic::Ecology<Rules> ecology({.seed = 42, .rules = {.capture = {.reach_per_tick_m = 0.02}}},
                                  trophic::backend::Kinematic::Params{});
  trophic::observe::Progress progress;
  ecology.run_until(6000.0, progress);
  progress.summary(std::cout, ecology.view());
}
