// SPDX-License-Identifier: MIT
// The contract of a slot: whether the last members of a hunted species may die.
#pragma once

#include <trophic/population/state.hpp>

#define TROPHIC_SENTENCE_Floor "bool may_die(Species, const View&) const; see trophic/death/floor/contract.hpp"

namespace trophic::death {

/// `may_die(species, view)`: returns whether a member of a hunted species may be caught or sacrificed now.
template <class P>
concept Floor = requires(const P policy, Species species, const View& view) {
  { policy.may_die(species, view) } -> std::same_as<bool>;
};

namespace ask {

template <class P>
[[nodiscard]] bool may_die(const P& policy, Species species, const View& view) {
  return for_species(policy, species).may_die(species, view);
}

}  // namespace ask

}  // namespace trophic::death
