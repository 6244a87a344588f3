// SPDX-License-Identifier: MIT
// The contract of a slot: which individuals perceive each other.
#pragma once

#include <functional>
#include <trophic/population/state.hpp>
#include <trophic/support/rng.hpp>

#define TROPHIC_SENTENCE_Visibility                                                                                     \
  "bool perceives(BodyIndex self, BodyIndex other, const View&, Rng&) const (with a State also const State& own); see " \
  "trophic/perception/visibility/contract.hpp"

namespace trophic::perception {

/// `perceives(self, other, view, rng)`: returns whether the individual in body self perceives the one in body other. Species
/// are checked elsewhere. The random stream belongs to the pair and the tick: a noisy rule returns the same value if called again
/// within a tick, independently of the other individuals that self observes.
template <class P>
concept Visibility = requires(const P policy, BodyIndex self, BodyIndex other, const View& view, Rng& rng) {
  { policy.perceives(self, other, view, rng) } -> std::same_as<bool>;
}
|| requires(const P policy, BodyIndex self, BodyIndex other, const View& view, Rng& rng, const StateOf<P> own) {
  { policy.perceives(self, other, view, rng, own) } -> std::same_as<bool>;
};

namespace ask {

template <class P>
[[nodiscard]] bool perceives(const P& policy, [[maybe_unused]] const StateOf<P>& own, BodyIndex self, BodyIndex other,
                             const View& view, Rng& rng) {
  const auto& rule = for_species(policy, view.robots[self].species);
  if constexpr (requires { rule.perceives(self, other, view, rng, own); }) {
    return rule.perceives(self, other, view, rng, own);
  } else {
    return rule.perceives(self, other, view, rng);
  }
}

}  // namespace ask

/// Bounds on what a robot can perceive: distance, tag and activity.
struct Horizon {
  double within_m = std::numeric_limits<double>::infinity();
  std::optional<int> tag = {};  ///< none: any tag
  bool only_active = false;
};

namespace ask {

/// A Visibility rule may declare in advance what is never perceived: `Horizon horizon(const Individual& self) const`. This does
/// not change results but makes the search in large ecologies faster. An inherited declaration is ignored, because the derived
/// rule may perceive more.
template <class P>
[[nodiscard]] Horizon horizon([[maybe_unused]] const P& policy, [[maybe_unused]] const Individual& self) {
  using Rule = AnswersForSpecies<P>;
  if constexpr (requires { requires std::same_as<decltype(&Rule::horizon), Horizon (Rule::*)(const Individual&) const>; }) {
    return for_species(policy, self.species).horizon(self);
  } else {
    return {};
  }
}

}  // namespace ask

/// The Visibility rule of a run at one tick, for other rules.
using Perceives = std::function<bool(BodyIndex self, BodyIndex other)>;

}  // namespace trophic::perception
