// SPDX-License-Identifier: MIT
// The contract of a slot: births without a death, and deaths without a birth.
#pragma once

#include <trophic/population/state.hpp>
#include <trophic/support/rng.hpp>

#define TROPHIC_SENTENCE_Recruitment                                                                                 \
  "std::size_t spare_bodies() const, bool leaves_spare(const Vacancy&, const View&) const and std::vector<Recruit> " \
  "recruits(const View&, Rng&) const (with a State also AllStates<P> states); see trophic/reproduction/recruitment/contract.hpp"

namespace trophic::reproduction {

/// A birth without a death.
struct Recruit {
  Species species = 0;                   ///< of the newborn
  std::vector<Ancestor> parents = {};    ///< parents, of the newborn's species; without any the genome is random
  double endowment_J = 0.0;              ///< energy that living parents give in equal parts; 0: the energy comes from outside
  std::optional<GroundPose> place = {};  ///< if empty: a free place next to the first living parent, or anywhere without one
  bool first_pays = false;               ///< whether the first living parent gives all of `endowment_J`
  friend bool operator==(const Recruit&, const Recruit&) = default;
};

/// A spare body is a body without an individual. It is not in the world: no individual perceives, meets or counts it, and no
/// engine moves it. Its tag is the next newborn's previous one. There are EcologyParams::robots bodies, which is the largest
/// number of living individuals.
///
/// `spare_bodies()`: returns how many bodies start without an individual, fewer than there are robots; these are the last ones.
/// `leaves_spare(vacancy, view)`: returns whether the body of a dying individual stays spare; otherwise the individual is
/// replaced at once by the rule Parent. `recruits(view, rng)`: returns the births of this tick, after all deaths or, for one
/// species, after its own deaths (Order). It is first called in the tick after the first decisions. A birth without a free body
/// or free space, or whose parents have too little energy left, does not take place but is counted (View::refused_births).
/// GenomeSource does not apply to these births, whose parents this rule names. If policies differ by species, spare bodies are
/// summed.
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

/// Whether a rule may name several parents of a birth, which events.csv then lists. A rule P that names at most one declares
/// `using NamesOneParent = P;`; a rule derived from it does not.
template <class P>
inline constexpr bool names_several_parents = true;
template <class P>
requires std::same_as<typename P::NamesOneParent, P>
inline constexpr bool names_several_parents<P> = false;

/// Whether individuals may be born by a rule without a parent that endows them: by default. A rule P by which living parents hand
/// over energy at each birth and each dead individual's body stays spare declares `using NoNewcomers = P;`; a rule derived from
/// it does not.
template <class P>
inline constexpr bool has_newcomers = true;
template <class P>
requires std::same_as<typename P::NoNewcomers, P>
inline constexpr bool has_newcomers<P> = false;

namespace ask {

template <class P>
[[nodiscard]] std::size_t spare_bodies(const P& policy) {
  if constexpr (requires { policy.spare_bodies(); }) return policy.spare_bodies();
  std::size_t sum = 0;
  if constexpr (requires { policy.of(0); }) {
    for (Species species = 0; species < P::count; ++species) sum += policy.of(species).spare_bodies();
  }
  return sum;
}

template <class P>
[[nodiscard]] std::vector<Recruit> recruits(const P& policy, [[maybe_unused]] const AllStates<P>& states, const View& view,
                                            Rng& rng) {
  if constexpr (requires { policy.of(0); }) {
    std::vector<Recruit> births;
    for (Species species = 0; species < P::count; ++species) {
      std::ranges::copy_if(recruits(policy.of(species), states, view, rng), std::back_inserter(births),
                           [&](const Recruit& birth) { return birth.species == species; });
    }
    return births;
  } else if constexpr (requires { policy.recruits(view, rng, states); }) {
    return policy.recruits(view, rng, states);
  } else {
    return policy.recruits(view, rng);
  }
}

}  // namespace ask

}  // namespace trophic::reproduction
