// SPDX-License-Identifier: MIT
// The prey that has escaped most often reproduces.
#pragma once

#include <trophic/reproduction/parent/contract.hpp>
#include <trophic/reproduction/parent/detail/pursuit.hpp>

namespace trophic::reproduction::parent {

/// Rule: the parent is the active prey with the most escapes in its life; among equals, the one closest to the vacant body. There
/// is none if no prey has escaped. An escape: a living predator that was within near_m of the active prey is now farther than
/// far_m. This is an explicit behavioural criterion for the reproduction of prey, which the paper's conclusion asks for. The two
/// distances are free parameters.   Reads: positions, species, activity, its own state.   Random draws: 0.
struct MostEscapes {
  static constexpr std::string_view name = "most_escapes";
  static constexpr std::string_view source = "not in the paper; its conclusion asks for an explicit criterion";

  using Params = detail::EscapeDistances;
  Params params;

  /// Per individual.
  struct State {
    std::vector<IndividualId> pursuers;  ///< predators that came near and are not yet far
    std::int64_t escapes = 0;
    static constexpr auto fields() { return std::tuple{field("pursuers", &State::pursuers), field("escapes", &State::escapes)}; }
  };
  [[nodiscard]] State born(const Individual&, const State*, const State&) const { return {}; }
  void on_walk(State& own, BodyIndex self, double, const View& view) const {
    detail::update_pursuers(own.pursuers, self, params, view, [&](IndividualId) { ++own.escapes; });
  }

  [[nodiscard]] std::optional<Ancestor> parent(const Vacancy& vacancy, const View& view, Rng&,
                                               std::span<const State> states) const {
    return detail::highest_ranked(vacancy, view, [&](BodyIndex body) {
      return states[body].escapes > 0 ? std::optional{states[body].escapes} : std::nullopt;
    });
  }
};
static_assert(Parent<MostEscapes>);

}  // namespace trophic::reproduction::parent
