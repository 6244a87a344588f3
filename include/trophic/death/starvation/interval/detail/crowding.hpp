// SPDX-License-Identifier: MIT
// An interval that shrinks with the number of hunters; the crowding intervals share it.
#pragma once

#include <trophic/params/params.hpp>
#include <trophic/population/outset.hpp>
#include <trophic/population/view.hpp>

namespace trophic::death::starvation::interval::detail {

struct Crowding {
  std::int64_t base_ticks = 25;
  std::int64_t min_interval_ticks = 2;
  std::size_t only_above = 0;
  static constexpr auto fields() {
    return std::tuple{
        field("base_ticks", &Crowding::base_ticks, at_least(1), "Delta = this value - number of hunters"),
        field("min_interval_ticks", &Crowding::min_interval_ticks, at_least(1), "smallest value of Delta"),
        field("only_above", &Crowding::only_above, at_least(0), "number of hunters above which procedures take place")};
  }
};

/// Returns Delta = base - p, where p is the number of hunters, but at least min_interval.
[[nodiscard]] inline std::int64_t interval_ticks(const Crowding& crowding, const View& view, OneSpecies only) {
  return std::max(crowding.min_interval_ticks, crowding.base_ticks - static_cast<std::int64_t>(view.count_hunters(only)));
}

/// Returns whether `interval` ticks have passed since the last procedure and there are enough hunters for another one.
[[nodiscard]] inline bool is_due(const Crowding& crowding, std::int64_t interval, std::int64_t last_tick, const View& view,
                                 OneSpecies only) {
  return view.tick - last_tick >= interval && view.count_hunters(only) > crowding.only_above;
}

/// A sentence if there can never be enough hunters for a procedure (Outset).
[[nodiscard]] inline std::string never_due(const Crowding& crowding, const Outset& outset) {
  if (crowding.only_above < outset.robots) return {};
  return "only_above = " + std::to_string(crowding.only_above) + ": no hunter ever starves, because there are " +
         std::to_string(outset.robots) + " robots";
}

}  // namespace trophic::death::starvation::interval::detail
