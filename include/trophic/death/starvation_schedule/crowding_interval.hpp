// SPDX-License-Identifier: MIT
// The more predators, the more often one starves.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <trophic/death/starvation_schedule/contract.hpp>
#include <trophic/params/params.hpp>
#include <tuple>

namespace trophic::death::starvation_schedule {

/// Rule: a starvation procedure is held every Delta = base - p ticks, p the number of hunters (Sec. "Predator Death", Eq.
/// 3: base 25). Delta is fixed at the start and again after each procedure; the released code evaluates it anew at every
/// tick (`reevaluated`) and holds no procedure with 7 hunters or fewer (`only_above`), which then waits, overdue. Delta
/// never falls below min_interval, 2: with 24 hunters, which only the released code's floor of 6 prey allows, that code waits two
/// ticks as well, since its clock restarts after the procedure. Reads: number of hunters,
/// clock.   Random draws: 0.
struct CrowdingInterval {
  static constexpr std::string_view name = "crowding_interval";

  struct Params {
    std::int64_t base_ticks = 25;
    std::int64_t min_interval_ticks = 2;
    std::size_t only_above = 0;
    bool reevaluated = false;
    static constexpr auto fields() {
      return std::tuple{
          field("base_ticks", &Params::base_ticks, at_least(1), "Delta = this - number of hunters"),
          field("min_interval_ticks", &Params::min_interval_ticks, at_least(1), "Delta never falls below this"),
          field("only_above", &Params::only_above, at_least(0), "no procedure unless there are more hunters than this"),
          field("reevaluated", &Params::reevaluated, "Delta follows the number of hunters at every tick")};
    }
  };
  Params params;

  [[nodiscard]] std::int64_t interval_ticks(const View& view) const {
    return std::max(params.min_interval_ticks, params.base_ticks - static_cast<std::int64_t>(view.count_hunters()));
  }

  [[nodiscard]] bool due(const StarvationClock& clock, const View& view) const {
    const std::int64_t interval = params.reevaluated ? interval_ticks(view) : clock.interval_ticks;
    return view.tick - clock.last_tick >= interval && view.count_hunters() > params.only_above;
  }
};
static_assert(StarvationSchedule<CrowdingInterval>);

}  // namespace trophic::death::starvation_schedule
