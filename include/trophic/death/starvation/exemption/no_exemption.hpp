// SPDX-License-Identifier: MIT
// No hunter is exempt.
#pragma once

#include <trophic/death/starvation/exemption/contract.hpp>

namespace trophic::death::starvation::exemption {

/// Rule: no hunter is exempt; hunger alone decides.   Reads: nothing.   Random draws: 0.
struct NoExemption {
  static constexpr std::string_view name = "no_exemption";
  static constexpr std::string_view source = "control";
  [[nodiscard]] bool is_exempt(BodyIndex, const View&, const perception::Perceives&) const { return false; }
};
static_assert(Exemption<NoExemption>);

}  // namespace trophic::death::starvation::exemption
