// SPDX-License-Identifier: MIT
// No hunter starves.
#pragma once

#include <trophic/death/starvation/contract.hpp>

namespace trophic::death::starvation {

/// Rule: hunger kills no hunter. This is the neutral policy of the slot.   Reads: nothing.   Random draws: 0.
struct NoStarvation {
  static constexpr std::string_view name = "no_starvation";
  static constexpr std::string_view source = "control";
  [[nodiscard]] Starving starving(const View&, const perception::Perceives&) const { return {}; }
};
static_assert(Starvation<NoStarvation>);

}  // namespace trophic::death::starvation
