// SPDX-License-Identifier: MIT
// The contract of a slot: food in space and time.
#pragma once

#include <trophic/population/view.hpp>
#include <trophic/support/rng.hpp>

#define TROPHIC_SENTENCE_Resource                                                                              \
  "ResourceField start(const Arena&, Rng&) const and void grow(ResourceField&, const View&, Rng&) const; see " \
  "trophic/energy/resource/contract.hpp"

namespace trophic::energy {

/// The world's own state. `view.field` is the field, for every rule and sensor to read; individuals take energy from it by the
/// rule Metabolism. Checkpoints hold it.
///
/// - `start(arena, rng)`: returns the field at the start
/// - `grow(field, view, rng)`: changes it once a tick, after the robots have moved and before they bite
/// Optional hooks, at their moments in a tick:
/// - `void on_bite(ResourceField&, std::size_t cell, double taken_J, BodyIndex self, const View&) const`; may change that cell
/// only
/// - `void on_death(ResourceField&, const Vacancy&, double left_J, const View&) const`: an individual, which is still there, dies
/// with this
///   energy, which is lost; what the hook adds to the field counts as grown
/// After each of them no cell may hold less than 0 J or no finite number: RuleError.
template <class P>
concept Resource = requires(const P policy, const Arena& arena, ResourceField& field, const View& view, Rng& rng) {
  { policy.start(arena, rng) } -> std::same_as<ResourceField>;
  {policy.grow(field, view, rng)};
};

}  // namespace trophic::energy
