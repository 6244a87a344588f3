// SPDX-License-Identifier: MIT
// A newborn's tag is uniformly random.
#pragma once

#include <string_view>
#include <trophic/perception/newborn_tag/contract.hpp>

namespace trophic::perception::newborn_tag {

/// Rule: founders and newborns show each of the brain's tags with equal probability, independently of the body's tag. This is an
/// alternative to KeepsBodyTag, because the paper is silent.   Reads: nothing.   Random draws: 1.
struct RandomTag {
  static constexpr std::string_view name = "random_tag";
  static constexpr std::string_view source = "paper: silent";
  [[nodiscard]] int tag(std::optional<int>, std::span<const int> tags, Rng& rng) const { return tags[rng.index(tags.size())]; }
};
static_assert(NewbornTag<RandomTag>);

}  // namespace trophic::perception::newborn_tag
