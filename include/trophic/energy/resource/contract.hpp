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
  "see trophic/energy/resource/contract.hpp"

namespace trophic::energy {

namespace detail {

TROPHIC_PROBE_NAME(on_bite)
TROPHIC_PROBE_NAME(on_death)
TROPHIC_PROBE_NAME(on_birth)
template <class P>
concept TakesBites = requires(const P policy, ResourceField& field, std::size_t cell, const View& view) {
  policy.on_bite(field, cell, 1.0, BodyIndex{}, view);
};
template <class P>
concept TakesDeaths = requires(const P policy, ResourceField& field, const Vacancy& death, const View& view) {
  policy.on_death(field, death, 1.0, view);
};
template <class P>
concept TakesBirths = requires(const P policy, ResourceField& field, std::span<const BodyIndex> parents, const View& view,
                               Rng& rng) {
  policy.on_birth(field, parents, view, rng);
};

}  // namespace detail

/// The state of the world. Every rule and sensor may read the field as `view.field`; individuals take energy from it under the
/// rule Metabolism. Checkpoints save it.
///
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
///   Recruitment took place; `parents` are the living ones; may change layers only
/// After each of them no cell may hold less than 0 J or no finite number: RuleError.
template <class P>
concept Resource = requires(const P policy, const Arena& arena, ResourceField& field, const View& view, Rng& rng) {
  { policy.start(arena, rng) } -> std::same_as<ResourceField>;
  {policy.grow(field, view, rng)};
  requires !detail::StateNames_on_bite<P> || detail::TakesBites<P>;
  requires !detail::StateNames_on_death<P> || detail::TakesDeaths<P>;
  requires !detail::StateNames_on_birth<P> || detail::TakesBirths<P>;
};

namespace ask {

template <class P>
void on_bite([[maybe_unused]] const P& policy, [[maybe_unused]] ResourceField& field, [[maybe_unused]] std::size_t cell,
             [[maybe_unused]] double taken_J, [[maybe_unused]] BodyIndex self, [[maybe_unused]] const View& view) {
  if constexpr (detail::TakesBites<P>) policy.on_bite(field, cell, taken_J, self, view);
}
template <class P>
void on_death([[maybe_unused]] const P& policy, [[maybe_unused]] ResourceField& field, [[maybe_unused]] const Vacancy& death,
              [[maybe_unused]] double left_J, [[maybe_unused]] const View& view) {
  if constexpr (detail::TakesDeaths<P>) policy.on_death(field, death, left_J, view);
}

}  // namespace ask

}  // namespace trophic::energy
