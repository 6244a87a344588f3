// SPDX-License-Identifier: MIT
// The more predators there were at the last starvation procedure, the sooner the next one comes.
#pragma once

#include <trophic/death/starvation/interval/contract.hpp>
#include <trophic/death/starvation/interval/detail/crowding.hpp>

namespace trophic::death::starvation::interval {

/// Rule: a starvation procedure takes place every Delta = base - p ticks, where p is the number of hunters (Sec. "Predator
/// Death", Eq. 3: base 25). Delta is fixed at the start and again after each procedure, so it depends on crowding with a delay;
/// the released code's interval has no delay (DirectCrowdingInterval). Delta never falls below min_interval (2), which the paper
/// derives from its floor of 7 prey. With only_above hunters or fewer (0 in the paper) a procedure waits, overdue.   Reads:
/// number of hunters, clock.   Random draws: 0.
struct DelayedCrowdingInterval {
  static constexpr std::string_view name = "delayed_crowding_interval";
  static constexpr std::string_view source = "paper, Sec. \"Predator Death\", Eq. 3";

  using Params = detail::Crowding;
  Params params;

  [[nodiscard]] std::string idle(const Outset& outset) const { return detail::never_due(params, outset); }
  [[nodiscard]] std::int64_t interval_ticks(const View& view, OneSpecies only = {}) const {
    return detail::interval_ticks(params, view, only);
  }
  [[nodiscard]] bool due(const StarvationClock& clock, const View& view, OneSpecies only = {}) const {
    return detail::is_due(params, clock.interval_ticks, clock.last_tick, view, only);
  }
};
static_assert(Interval<DelayedCrowdingInterval>);

}  // namespace trophic::death::starvation::interval
