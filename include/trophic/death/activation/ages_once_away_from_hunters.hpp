// SPDX-License-Identifier: MIT
// Newborn prey stay inactive until they are away from every predator, and only then begin to age.
#pragma once

#include <trophic/death/activation/contract.hpp>
#include <trophic/death/activation/detail/away_from_hunters.hpp>

namespace trophic::death::activation {

/// Rule (released code): like ActiveAwayFromHunters, but a newborn's age counts from its activation.   Reads: positions,
/// species.   Random draws: 0.
struct AgesOnceAwayFromHunters {
  static constexpr std::string_view name = "ages_once_away_from_hunters";
  static constexpr std::string_view source = "released code";

  using Params = detail::SafeDistance;
  Params params;

  [[nodiscard]] std::string idle(const Outset& outset) const { return detail::never_away(params, outset); }
  [[nodiscard]] Activates activates(BodyIndex body, const View& view) const {
    return detail::away_from_hunters(params, body, view) ? Activates::yes_and_restarts_age : Activates::no;
  }
};
static_assert(Activation<AgesOnceAwayFromHunters>);

}  // namespace trophic::death::activation
