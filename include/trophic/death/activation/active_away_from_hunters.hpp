// SPDX-License-Identifier: MIT
// Newborn prey stay inactive until they are away from every predator.
#pragma once

#include <trophic/death/activation/contract.hpp>
#include <trophic/death/activation/detail/away_from_hunters.hpp>

namespace trophic::death::activation {

/// Rule: an inactive newborn becomes active once it is farther than distance from every individual that eats its species,
/// whatever the tags (Sec. "Prey Death", against "spawn-killing"). The paper gives no distance. The released code uses 5 m, as
/// does an early draft of Sec. "Birth", a comment in the LaTeX source: a newborn cannot "immediately interact with other robots"
/// and is safe "until they move five units away from any predator". Founders of hunted species also start inactive, as in the
/// released code; the paper is silent, and FoundersStartActive is the alternative reading. Age counts from birth; in the released
/// code it counts from activation (AgesOnceAwayFromHunters).   Reads: positions, species.   Random draws: 0.
struct ActiveAwayFromHunters {
  static constexpr std::string_view name = "active_away_from_hunters";
  static constexpr std::string_view source = "paper, Sec. \"Prey Death\"; silent on the distance: released code's";

  using Params = detail::SafeDistance;
  Params params;

  [[nodiscard]] std::string idle(const Outset& outset) const { return detail::never_away(params, outset); }
  [[nodiscard]] Activates activates(BodyIndex body, const View& view) const {
    return detail::away_from_hunters(params, body, view) ? Activates::yes : Activates::no;
  }
};
static_assert(Activation<ActiveAwayFromHunters>);

}  // namespace trophic::death::activation
