// SPDX-License-Identifier: MIT
// Procedures are held, but nobody starves.
#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <trophic/death/starvation/contract.hpp>

namespace trophic::death::starvation {

/// Rule: hunger kills nobody; the schedule goes on.   Reads: nothing.   Random draws: 0.
struct NobodyStarves {
  static constexpr std::string_view name = "nobody_starves";
  static constexpr std::string_view source = "control";
  [[nodiscard]] std::optional<BodyIndex> victim(const View&, const std::function<bool(BodyIndex)>&) const { return std::nullopt; }
};
static_assert(Starvation<NobodyStarves>);

}  // namespace trophic::death::starvation
