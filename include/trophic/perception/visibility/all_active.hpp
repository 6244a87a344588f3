// SPDX-License-Identifier: MIT
// The control without tags: every active individual is perceived.
#pragma once

#include <trophic/perception/visibility/contract.hpp>

namespace trophic::perception::visibility {

/// Rule: self perceives every active individual, whatever the tags. This is the baseline for the effect of tags. Reads: other's
/// activity.   Random draws: 0.
struct AllActive {
  static constexpr std::string_view name = "all_active";
  static constexpr std::string_view source = "control";
  [[nodiscard]] bool perceives(BodyIndex, BodyIndex other, const View& view, Rng&) const { return view.robots[other].active; }
  [[nodiscard]] Horizon horizon(const Individual&) const { return {.only_active = true}; }
};
static_assert(Visibility<AllActive>);

}  // namespace trophic::perception::visibility
