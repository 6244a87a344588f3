// SPDX-License-Identifier: MIT
// The contract of a part of starvation::Procedure: which hunters a starvation procedure kills.
#pragma once

#include <functional>
#include <trophic/population/view.hpp>

namespace trophic::death::starvation {

/// Returns whether a hunter is exempt. Observers are notified of each exempt hunter for which a choice calls this.
using IsExempt = std::function<bool(BodyIndex hunter)>;

/// `victims(view, is_exempt)`: returns the hunters that starve in a procedure, in order and each once. Optional, for by_species:
/// a last argument `OneSpecies only`, the species whose hunters may starve.
template <class P, class... Only>
concept Choice = requires(const P policy, const View& view, const IsExempt& is_exempt, Only... only) {
  { policy.victims(view, is_exempt, only...) } -> std::same_as<std::vector<BodyIndex>>;
};

}  // namespace trophic::death::starvation
