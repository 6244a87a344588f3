// SPDX-License-Identifier: MIT
// Robots perceive robots with their own tag, up to a range.
#pragma once

#include <trophic/perception/visibility/contract.hpp>

namespace trophic::perception::visibility {

/// Rule: self perceives other iff their tags are equal, other is active, and other is at most range away. This is SameTag for a
/// sensor that does not reach across the whole arena. The paper sets no limit.   Reads: positions, both tags, other's activity.
/// Random draws: 0.
struct WithinRange {
  static constexpr std::string_view name = "within_range";
  static constexpr std::string_view source = "not in the paper";

  struct Params {
    double range_m = 5.0;
    static constexpr auto fields() {
      return std::tuple{field("range_m", &Params::range_m, at_least(0.0), "distance beyond which robots are not perceived")};
    }
  };
  Params params;

  [[nodiscard]] bool perceives(BodyIndex self, BodyIndex other, const View& view, Rng&) const {
    const Individual& seen = view.robots[other];
    return view.robots[self].tag == seen.tag && seen.active && view.distance_m(self, other) <= params.range_m;
  }
  [[nodiscard]] Horizon horizon(const Individual& self) const {
    return {.within_m = params.range_m, .tag = self.tag, .only_active = true};
  }
};
static_assert(Visibility<WithinRange>);

}  // namespace trophic::perception::visibility
