// SPDX-License-Identifier: MIT
// The prey that gained the most distance from the dying predator reproduces.
#pragma once

#include <trophic/reproduction/parent/contract.hpp>
#include <trophic/reproduction/parent/detail/pursuit.hpp>

namespace trophic::reproduction::parent {

/// Rule: the parent is the active prey whose distance to the dying predator grew most in the last window_ticks ticks, or since
/// the younger of the two was born; among equal gains the closest one; there is none if no prey gained distance. Gain of prey i
/// from predator h at tick t: |x_i(t) - x_h(t)| - |x_i(t - w) - x_h(t - w)|. The window is a free parameter.   Reads: positions,
/// species, activity, its own state.   Random draws: 0.
struct FastestEscape {
  static constexpr std::string_view name = "fastest_escape";
  static constexpr std::string_view source = "not in the paper; its conclusion asks for an explicit criterion";

  struct Params {
    std::int64_t window_ticks = 6;
    static constexpr auto fields() {
      return std::tuple{field("window_ticks", &Params::window_ticks, between(1, 1000),
                              "number of ticks over which the gain in distance is measured")};
    }
  };
  Params params;

  /// Per individual: its positions at the last ticks, in order of time and including this tick. Both lists have the same length.
  struct State {
    std::vector<double> x_m;
    std::vector<double> y_m;
    static constexpr auto fields() { return std::tuple{field("x_m", &State::x_m), field("y_m", &State::y_m)}; }
  };
  [[nodiscard]] State born(const Individual&, const State*, const State&) const { return {}; }
  void on_walk(State& own, BodyIndex self, double, const View& view) const {
    own.x_m.push_back(view.poses[self].x_m);
    own.y_m.push_back(view.poses[self].y_m);
    if (own.x_m.size() <= static_cast<std::size_t>(params.window_ticks) + 1) return;
    own.x_m.erase(own.x_m.begin());
    own.y_m.erase(own.y_m.begin());
  }

  [[nodiscard]] std::optional<Ancestor> parent(const Vacancy& vacancy, const View& view, Rng&,
                                               std::span<const State> states) const {
    return detail::highest_ranked(vacancy, view, [&](BodyIndex body) -> std::optional<double> {
      const double gain_m = gain(states[body], states[vacancy.body]);
      return gain_m > 0.0 ? std::optional{gain_m} : std::nullopt;
    });
  }

 private:
  [[nodiscard]] static double gain(const State& prey, const State& hunter) {
    const std::size_t places = std::min(prey.x_m.size(), hunter.x_m.size());
    if (places < 2) return 0.0;
    const auto distance_m = [&](std::size_t ticks_ago) {
      const std::size_t i = prey.x_m.size() - 1 - ticks_ago;
      const std::size_t h = hunter.x_m.size() - 1 - ticks_ago;
      return trophic::distance_m(GroundPose{.x_m = prey.x_m[i], .y_m = prey.y_m[i]},
                                 GroundPose{.x_m = hunter.x_m[h], .y_m = hunter.y_m[h]});
    };
    return distance_m(0) - distance_m(places - 1);
  }
};
static_assert(Parent<FastestEscape>);

}  // namespace trophic::reproduction::parent
