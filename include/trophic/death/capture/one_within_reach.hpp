// SPDX-License-Identifier: MIT
// Hunters act in random order, with one catch each and a handling time.
#pragma once

#include <trophic/death/capture/contract.hpp>

namespace trophic::death::capture {

/// Rule: in random order, each hunter catches the closest active victim within reach that has not been caught yet; then it does
/// not hunt for `handling_ticks` ticks. In a well-mixed world of N victims a free hunter catches a victim with probability 1 - (1
/// - a)^N, where a = pi reach^2 / area: Holling's second functional response, as in [rosenzweig1963]. All parameters are free.
/// Reads: positions, species, activity, its own state.   Random draws: number of hunters - 1.
struct OneWithinReach {
  static constexpr std::string_view name = "one_within_reach";
  static constexpr std::string_view source = "not in the paper; as in [rosenzweig1963]";

  struct Params {
    double reach_m = 1.0;
    std::int64_t handling_ticks = 0;
    static constexpr auto fields() {
      return std::tuple{field("reach_m", &Params::reach_m, above(0.0), "distance within which a victim is caught"),
                        field("handling_ticks", &Params::handling_ticks, at_least(0),
                              "time after a catch during which a hunter does not hunt")};
    }
  };
  Params params;

  struct State {
    std::int64_t busy_until_tick = 0;
    static constexpr auto fields() { return std::tuple{field("busy_until_tick", &State::busy_until_tick)}; }
  };
  [[nodiscard]] State born(const Individual&, const State*, const State&) const { return {}; }
  void on_catch(State& own, BodyIndex, BodyIndex, const View& view) const {
    own.busy_until_tick = view.tick + params.handling_ticks;
  }

  [[nodiscard]] std::vector<Capture> captures(const View& view, Rng& rng, std::span<const State> states) const {
    std::vector<BodyIndex> hunters;
    for (BodyIndex body = 0; body < view.robots.size(); ++body) {
      const bool is_free = view.robots[body].lives() && view.tick > states[body].busy_until_tick;
      if (is_free && view.web.hunts(view.robots[body].species)) hunters.push_back(body);
    }
    rng.shuffle(std::span{hunters});
    std::vector<bool> caught(view.robots.size());
    std::vector<Capture> captures;
    for (const BodyIndex hunter : hunters) {
      if (caught[hunter]) continue;
      const auto eats = [&](Species other) { return view.web.eats(view.robots[hunter].species, other); };
      const auto is_prey = [&](BodyIndex other) {
        return !caught[other] && view.robots[other].active && eats(view.robots[other].species);
      };
      const auto victim = view.closest(hunter, is_prey, {.within_m = params.reach_m, .among = view.marks(eats, {}, true)});
      if (!victim) continue;
      caught[*victim] = true;
      captures.push_back({.hunter = hunter, .victim = *victim});
    }
    return captures;
  }
};
static_assert(CaptureRule<OneWithinReach>);

}  // namespace trophic::death::capture
