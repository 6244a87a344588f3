// SPDX-License-Identifier: MIT
// Newborns can be caught at once.
#pragma once

#include <trophic/death/activation/contract.hpp>

namespace trophic::death::activation {

/// Rule: a newborn becomes active at the first tick after its birth, wherever it is. This is the control with spawn-killing.
/// Reads: nothing.   Random draws: 0.
struct AlwaysActive {
  static constexpr std::string_view name = "always_active";
  static constexpr std::string_view source = "control";
  [[nodiscard]] Activates activates(BodyIndex, const View&) const { return Activates::yes; }
};
static_assert(Activation<AlwaysActive>);

}  // namespace trophic::death::activation
