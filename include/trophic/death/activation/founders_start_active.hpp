// SPDX-License-Identifier: MIT
// Founders are active from the start; later newborn prey stay inactive until they are away from every predator.
#pragma once

#include <trophic/death/activation/contract.hpp>
#include <trophic/death/activation/detail/away_from_hunters.hpp>

namespace trophic::death::activation {

/// Rule: like ActiveAwayFromHunters, but a founder becomes active at the first tick, wherever it stands. Founders are the
/// individuals whose ids are below the number of bodies, because ids count births from 0. The paper is silent: "a newborn prey
/// must first move a certain minimum distance away from any predators" (Sec. "Prey Death") does not settle whether a founder is a
/// newborn. ActiveAwayFromHunters is the alternative reading.   Reads: positions, species, own id.   Random draws: 0.
struct FoundersStartActive {
  static constexpr std::string_view name = "founders_start_active";
  static constexpr std::string_view source = "paper: silent; a reading of Sec. \"Prey Death\"; distance: released code";

  using Params = detail::SafeDistance;
  Params params;

  [[nodiscard]] std::string idle(const Outset& outset) const { return detail::never_away(params, outset); }
  [[nodiscard]] Activates activates(BodyIndex body, const View& view) const {
    const bool is_founder = view.robots[body].id < view.robots.size();
    return is_founder || detail::away_from_hunters(params, body, view) ? Activates::yes : Activates::no;
  }
};
static_assert(Activation<FoundersStartActive>);

}  // namespace trophic::death::activation
