// SPDX-License-Identifier: MIT
// A newborn's tag is a fair coin.
#pragma once

#include <optional>
#include <string_view>
#include <trophic/perception/newborn_tag/contract.hpp>

namespace trophic::perception::newborn_tag {

/// Rule: founders and newborns show -1 or +1 with equal probability, whatever their body showed: an alternative to
/// KeepsBodyTag where the paper is silent.   Reads: nothing.   Random draws: 1.
struct RandomTag {
  static constexpr std::string_view name = "random_tag";
  static constexpr std::string_view source = "paper: silent";
  [[nodiscard]] int tag(std::optional<int>, Rng& rng) const { return rng.chance(0.5) ? 1 : -1; }
};
static_assert(NewbornTag<RandomTag>);

}  // namespace trophic::perception::newborn_tag
