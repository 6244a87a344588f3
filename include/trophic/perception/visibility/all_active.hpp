// SPDX-License-Identifier: MIT
// The control without tags: everybody active is perceived.
#pragma once

#include <string_view>
#include <trophic/perception/visibility/contract.hpp>

namespace trophic::perception::visibility {

/// Rule: self perceives every active individual, whatever the tags: the baseline that shows what tagging does. Reads:
/// other's activity.   Random draws: 0.
struct Everybody {
  static constexpr std::string_view name = "everybody";
  static constexpr std::string_view source = "control";
  [[nodiscard]] bool perceives(BodyIndex, BodyIndex other, const View& view, Rng&) const { return view.robots[other].active; }
  [[nodiscard]] Horizon horizon(const Individual&) const { return {.only_active = true}; }
};
static_assert(Visibility<Everybody>);

}  // namespace trophic::perception::visibility
