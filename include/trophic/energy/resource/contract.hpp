// SPDX-License-Identifier: MIT
// The contract of a slot: food in space and time.
#pragma once

#include <trophic/population/state.hpp>
#include <trophic/support/rng.hpp>

#define TROPHIC_SENTENCE_Resource                                                                                       \
  "ResourceField start(const Arena&, Rng&) const and void grow(ResourceField&, const View&, Rng&) const; on_bite, "     \
  "on_death and on_birth, if there are any, must be callable as void on_bite(ResourceField&, std::size_t cell, double " \
  "taken_J, BodyIndex, const View&) const, void on_death(ResourceField&, const Vacancy&, double left_J, const View&) "  \
  "const and void on_birth(ResourceField&, std::span<const BodyIndex> parents, const View&, Rng&) const; "              \
  "a rule of several foods has food_names and other arguments; see trophic/energy/resource/contract.hpp"

namespace trophic::energy {

namespace detail {

TROPHIC_PROBE_NAME(on_bite)
TROPHIC_PROBE_NAME(on_death)
TROPHIC_PROBE_NAME(on_birth)
/// `Of`: ResourceField for a rule of one food, std::span<ResourceField> for one of several.
template <class P, class Of>
concept TakesDeathsOf = requires(const P policy, Of& field, const Vacancy& death, const View& view) {
  policy.on_death(field, death, 1.0, view);
};
template <class P>
concept TakesBites = requires(const P policy, ResourceField& field, std::size_t cell, const View& view) {
  policy.on_bite(field, cell, 1.0, BodyIndex{}, view);
};
template <class P>
concept TakesBitesOfFoods = requires(const P policy, std::span<ResourceField> foods, std::size_t number, const View& view) {
  policy.on_bite(foods, number, number, 1.0, BodyIndex{}, view);
};
template <class P>
concept TakesDeaths = TakesDeathsOf<P, ResourceField> || TakesDeathsOf<P, std::span<ResourceField>>;
template <class P, class Of>
concept TakesBirthsOf = requires(const P policy, Of& field, std::span<const BodyIndex> parents, const View& view, Rng& rng) {
  policy.on_birth(field, parents, view, rng);
};
template <class P>
concept TakesBirths = TakesBirthsOf<P, ResourceField> || TakesBirthsOf<P, std::span<ResourceField>>;

}  // namespace detail

/// A rule of one food, a field of the world:
/// - `start(arena, rng)`: returns the field at the start
/// - `grow(field, view, rng)`: changes it once a tick, after the robots have moved and before they bite; by the rule Order in
/// turn
///   after all acts
/// Optional hooks, at their moments in a tick:
/// - `void on_bite(ResourceField&, std::size_t cell, double taken_J, BodyIndex self, const View&) const`; may change that cell
///   only
/// - `void on_death(ResourceField&, const Vacancy&, double left_J, const View&) const`: an individual, which is still there, dies
///   with this energy, which is lost; what the hook adds to the field counts as grown
/// - `void on_birth(ResourceField&, std::span<const BodyIndex> parents, const View&, Rng&) const`: a birth of the rule
///   Recruitment took place; `parents` are the living ones; may change zones and layers, no food
template <class P>
concept OneFood = requires(const P policy, const Arena& arena, ResourceField& field, const View& view, Rng& rng) {
  { policy.start(arena, rng) } -> std::same_as<ResourceField>;
  {policy.grow(field, view, rng)};
  requires !detail::StateNames_on_bite<P> || detail::TakesBites<P>;
  requires !detail::StateNames_on_death<P> || detail::TakesDeathsOf<P, ResourceField>;
  requires !detail::StateNames_on_birth<P> || detail::TakesBirthsOf<P, ResourceField>;
};

/// A rule of several foods has `static constexpr std::array<std::string_view, N> food_names` and the same functions for all of
/// them: `start` returns a std::vector<ResourceField>, and the others have a std::span<ResourceField> in place of the field, with
/// one field for each food. `on_bite(foods, food, cell, taken_J, self, view)` may change that cell of that food only. resource::
/// Foods makes such a rule from rules of one food.
template <class P>
concept SeveralFoods = requires(const P policy, const Arena& arena, std::span<ResourceField> foods, const View& view, Rng& rng) {
  std::span<const std::string_view>{P::food_names};
  { policy.start(arena, rng) } -> std::same_as<std::vector<ResourceField>>;
  {policy.grow(foods, view, rng)};
  requires !detail::StateNames_on_bite<P> || detail::TakesBitesOfFoods<P>;
  requires !detail::StateNames_on_death<P> || detail::TakesDeathsOf<P, std::span<ResourceField>>;
  requires !detail::StateNames_on_birth<P> || detail::TakesBirthsOf<P, std::span<ResourceField>>;
};

/// The state of the world. Every rule and sensor may read each food's field as `view.foods`; individuals take energy from it
/// under the rule Metabolism. Checkpoints save it. After each call no cell may hold less than 0 J or no finite number:
/// RuleError. What a call adds to a cell counts as grown, what it takes away as destroyed.
template <class P>
concept Resource = OneFood<P> || SeveralFoods<P>;

/// The names of a rule's foods; empty for a rule of one food.
template <class P>
inline constexpr std::span<const std::string_view> food_names{};
template <SeveralFoods P>
inline constexpr std::span<const std::string_view> food_names<P> = P::food_names;

namespace ask {

template <class P>
[[nodiscard]] std::vector<ResourceField> start(const P& policy, const Arena& arena, Rng& rng) {
  if constexpr (SeveralFoods<P>) {
    return policy.start(arena, rng);
  } else {
    return {policy.start(arena, rng)};
  }
}
template <class P>
void grow(const P& policy, std::span<ResourceField> foods, const View& view, Rng& rng) {
  if constexpr (SeveralFoods<P>) {
    policy.grow(foods, view, rng);
  } else {
    policy.grow(foods.front(), view, rng);
  }
}
template <class P>
void on_bite([[maybe_unused]] const P& policy, [[maybe_unused]] std::span<ResourceField> foods, [[maybe_unused]] std::size_t food,
             [[maybe_unused]] std::size_t cell, [[maybe_unused]] double taken_J, [[maybe_unused]] BodyIndex self,
             [[maybe_unused]] const View& view) {
  if constexpr (detail::TakesBitesOfFoods<P>) {
    policy.on_bite(foods, food, cell, taken_J, self, view);
  } else if constexpr (detail::TakesBites<P>) {
    policy.on_bite(foods[food], cell, taken_J, self, view);
  }
}
template <class P>
void on_death([[maybe_unused]] const P& policy, [[maybe_unused]] std::span<ResourceField> foods,
              [[maybe_unused]] const Vacancy& death, [[maybe_unused]] double left_J, [[maybe_unused]] const View& view) {
  if constexpr (detail::TakesDeathsOf<P, ResourceField>) {
    policy.on_death(foods.front(), death, left_J, view);
  } else if constexpr (detail::TakesDeaths<P>) {
    policy.on_death(foods, death, left_J, view);
  }
}
template <class P>
void on_birth([[maybe_unused]] const P& policy, [[maybe_unused]] std::span<ResourceField> foods,
              [[maybe_unused]] std::span<const BodyIndex> parents, [[maybe_unused]] const View& view, [[maybe_unused]] Rng& rng) {
  if constexpr (detail::TakesBirthsOf<P, ResourceField>) {
    policy.on_birth(foods.front(), parents, view, rng);
  } else if constexpr (detail::TakesBirths<P>) {
    policy.on_birth(foods, parents, view, rng);
  }
}

}  // namespace ask

}  // namespace trophic::energy
