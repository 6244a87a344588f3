// SPDX-License-Identifier: MIT
// The contract of a slot: births without a death, into spare bodies.
#pragma once

#include <trophic/population/state.hpp>
#include <trophic/support/rng.hpp>

#define TROPHIC_SENTENCE_Recruitment                                                                                 \
  "std::size_t spare_bodies() const, bool leaves_spare(const Vacancy&, const View&) const and std::vector<Recruit> " \
  "recruits(const View&, Rng&) const (with a State also AllStates<P> states); see trophic/reproduction/recruitment/contract.hpp"

namespace trophic::reproduction {

/// A birth into a spare body.
struct Recruit {
  BodyIndex body = 0;                   ///< a body without an individual
  Species species = 0;                  ///< of the newborn
  std::optional<Ancestor> parent = {};  ///< of the newborn's species; without one the genome is random
  friend bool operator==(const Recruit&, const Recruit&) = default;
};

/// A spare body is a body without an individual. It keeps walking with its last target angle, and its tag is the next newborn's
/// previous one; it is of no species, inactive and not counted, so that no individual perceives, catches or inherits from it.
///
/// `spare_bodies()`: returns how many bodies start without an individual, fewer than the robots; they are the last ones.
/// `leaves_spare(vacancy, view)`: returns whether the body of a dying individual stays without one; otherwise the Parent rule
/// replaces it at once. `recruits(view, rng)`: returns the births of this tick, after all deaths, each in another spare body.
/// GenomeSource is not applied to them: their parent is the one that this rule names.
template <class P>
concept Recruitment = requires(const P policy, const Vacancy& vacancy, const View& view) {
  { policy.spare_bodies() } -> std::same_as<std::size_t>;
  { policy.leaves_spare(vacancy, view) } -> std::same_as<bool>;
}
&&(
    requires(const P policy, const View& view, Rng& rng) {
      { policy.recruits(view, rng) } -> std::same_as<std::vector<Recruit>>;
    } ||
    requires(const P policy, const View& view, Rng& rng, AllStates<P> states) {
      { policy.recruits(view, rng, states) } -> std::same_as<std::vector<Recruit>>;
    });

namespace ask {

template <class P>
[[nodiscard]] std::vector<Recruit> recruits(const P& policy, [[maybe_unused]] const AllStates<P>& states, const View& view,
                                            Rng& rng) {
  if constexpr (requires { policy.recruits(view, rng, states); }) {
    return policy.recruits(view, rng, states);
  } else {
    return policy.recruits(view, rng);
  }
}

}  // namespace ask

}  // namespace trophic::reproduction
