// SPDX-License-Identifier: MIT
// The contract of a part of starvation::Procedure: when a starvation procedure takes place.
#pragma once

#include <trophic/params/params.hpp>
#include <trophic/population/view.hpp>

namespace trophic::death::starvation {

/// The time of the last starvation procedure, and the interval that was fixed then.
struct StarvationClock {
  std::int64_t last_tick = 0;
  std::int64_t interval_ticks = 0;
  static constexpr auto fields() {
    return std::tuple{field("last_tick", &StarvationClock::last_tick), field("interval_ticks", &StarvationClock::interval_ticks)};
  }
};

/// `interval_ticks(view)`: returns the current number of ticks between two starvation procedures; `due(clock, view)`: returns
/// whether one takes place at this tick. Optional, for by_species: a last argument `OneSpecies only`, the species whose hunters
/// count.
template <class P, class... Only>
concept Interval = requires(const P policy, const StarvationClock& clock, const View& view, Only... only) {
  { policy.interval_ticks(view, only...) } -> std::same_as<std::int64_t>;
  { policy.due(clock, view, only...) } -> std::same_as<bool>;
};

}  // namespace trophic::death::starvation
