// SPDX-License-Identifier: MIT
// The prey that last escaped from the dying predator reproduces.
#pragma once

#include <trophic/reproduction/parent/contract.hpp>
#include <trophic/reproduction/parent/detail/pursuit.hpp>

namespace trophic::reproduction::parent {

/// Rule: the parent is the active prey that last escaped from the dying predator; of several in the same tick, the closest; there
/// is none if no prey escaped from it. An escape: the predator was within near_m of the active prey and is now farther than
/// far_m. The two distances are free parameters.   Reads: positions, species, activity, its own state.   Random draws: 0.
struct LastEscapee {
  static constexpr std::string_view name = "last_escapee";
  static constexpr std::string_view source = "not in the paper; its conclusion asks for an explicit criterion";

  using Params = detail::EscapeDistances;
  Params params;

  /// Per individual. `hunters` and `ticks` have the same length.
  struct State {
    std::vector<IndividualId> pursuers;  ///< predators that came near and are not yet far
    std::vector<IndividualId> hunters;   ///< predators from which it has escaped, each once
    std::vector<std::int64_t> ticks;     ///< time of the last escape from each
    static constexpr auto fields() {
      return std::tuple{field("pursuers", &State::pursuers), field("hunters", &State::hunters), field("ticks", &State::ticks)};
    }
  };
  [[nodiscard]] State born(const Individual&, const State*, const State&) const { return {}; }
  void on_walk(State& own, BodyIndex self, double, const View& view) const {
    detail::update_pursuers(own.pursuers, self, params, view, [&](IndividualId hunter) { record(own, hunter, view); });
  }

  [[nodiscard]] std::optional<Ancestor> parent(const Vacancy& vacancy, const View& view, Rng&,
                                               std::span<const State> states) const {
    const IndividualId dying = view.robots[vacancy.body].id;
    return detail::highest_ranked(vacancy, view, [&](BodyIndex body) -> std::optional<std::int64_t> {
      const auto place = place_of(states[body], dying);
      return place < states[body].ticks.size() ? std::optional{states[body].ticks[place]} : std::nullopt;
    });
  }

 private:
  [[nodiscard]] static std::size_t place_of(const State& own, IndividualId hunter) {
    return static_cast<std::size_t>(std::ranges::find(own.hunters, hunter) - own.hunters.begin());
  }

  /// Hunters that have died are dropped, so the lists do not grow forever.
  static void record(State& own, IndividualId hunter, const View& view) {
    State kept{.pursuers = {}, .hunters = {hunter}, .ticks = {view.tick}};
    for (std::size_t place = 0; place < own.ticks.size(); ++place) {
      const IndividualId other = own.hunters[place];
      if (other == hunter || std::ranges::find(view.robots, other, &Individual::id) == view.robots.end()) continue;
      kept.hunters.push_back(other);
      kept.ticks.push_back(own.ticks[place]);
    }
    own.hunters = std::move(kept.hunters);
    own.ticks = std::move(kept.ticks);
  }
};
static_assert(Parent<LastEscapee>);

}  // namespace trophic::reproduction::parent
