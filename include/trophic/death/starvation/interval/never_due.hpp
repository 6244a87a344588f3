// SPDX-License-Identifier: MIT
// No starvation procedure ever takes place.
#pragma once

#include <trophic/death/starvation/interval/contract.hpp>

namespace trophic::death::starvation::interval {

/// Rule: no starvation procedure takes place. This is the control for the effect of starvation.   Reads: nothing.   Random draws:
/// 0.
struct NeverDue {
  static constexpr std::string_view name = "never_due";
  static constexpr std::string_view source = "control";
  [[nodiscard]] std::int64_t interval_ticks(const View&, OneSpecies = {}) const {
    return std::numeric_limits<std::int64_t>::max();
  }
  [[nodiscard]] bool due(const StarvationClock&, const View&, OneSpecies = {}) const { return false; }
};
static_assert(Interval<NeverDue>);

}  // namespace trophic::death::starvation::interval
