// SPDX-License-Identifier: MIT
// The contract of a slot: when a starvation procedure is held.
#pragma once

#include <concepts>
#include <cstdint>
#include <trophic/population/view.hpp>
#include <tuple>

#define TROPHIC_SENTENCE_StarvationSchedule                                                                      \
  "std::int64_t interval_ticks(const View&) const and bool due(const StarvationClock&, const View&) const; see " \
  "trophic/death/starvation_schedule/contract.hpp"

namespace trophic::death {

/// When the starvation procedure ran last and the interval fixed then.
struct StarvationClock {
  std::int64_t last_tick = 0;
  std::int64_t interval_ticks = 0;
  static constexpr auto saved() { return std::tuple{&StarvationClock::last_tick, &StarvationClock::interval_ticks}; }
};

/// `interval_ticks(view)`: ticks between two starvation procedures as of now; `due(clock, view)`: whether one is held at
/// this tick.
template <class P>
concept StarvationSchedule = requires(const P policy, const StarvationClock& clock, const View& view) {
  { policy.interval_ticks(view) } -> std::same_as<std::int64_t>;
  { policy.due(clock, view) } -> std::same_as<bool>;
};

}  // namespace trophic::death
