// SPDX-License-Identifier: MIT
// The more predators there are now, the sooner one starves.
#pragma once

#include <trophic/death/starvation/interval/contract.hpp>
#include <trophic/death/starvation/interval/detail/crowding.hpp>

namespace trophic::death::starvation::interval {

/// Rule (released code): a starvation procedure takes place once Delta = base - p ticks have passed since the last one, where p
/// is the number of hunters at this tick. Births and deaths since then count, unlike in DelayedCrowdingInterval. With only_above
/// hunters or fewer (7 in the released code) a procedure waits, overdue. Delta never falls below min_interval (2): with 24
/// hunters the released code also waits two ticks, because its clock restarts after the procedure.   Reads: number of hunters,
/// time of the last procedure.   Random draws: 0.
struct DirectCrowdingInterval {
  static constexpr std::string_view name = "direct_crowding_interval";
  static constexpr std::string_view source = "released code";

  using Params = detail::Crowding;
  Params params;

  [[nodiscard]] std::string idle(const Outset& outset) const { return detail::never_due(params, outset); }
  [[nodiscard]] std::int64_t interval_ticks(const View& view, OneSpecies only = {}) const {
    return detail::interval_ticks(params, view, only);
  }
  [[nodiscard]] bool due(const StarvationClock& clock, const View& view, OneSpecies only = {}) const {
    return detail::is_due(params, interval_ticks(view, only), clock.last_tick, view, only);
  }
};
static_assert(Interval<DirectCrowdingInterval>);

}  // namespace trophic::death::starvation::interval
