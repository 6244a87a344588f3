// SPDX-License-Identifier: MIT
// The hungriest predator that is not exempt starves; if all are exempt, none does.
#pragma once

#include <trophic/death/starvation/choice/contract.hpp>
#include <trophic/death/starvation/choice/detail/by_hunger.hpp>

namespace trophic::death::starvation::choice {

/// Rule: the hunter with the highest hunger (ticks since birth or the last catch) dies; if it is exempt, the next hungriest does.
/// The text has "the next oldest predator dies" (Sec. "Predator Death"), here read as the next hungriest, as in the released
/// code; HungriestElseOldest reads it literally. In ties the earlier born comes first. If all are exempt, none dies; in the
/// released code the hungriest then does (HungriestNonexemptElseHungriest).   Reads: hunger, ids.   Random draws: 0.
struct HungriestNonexempt {
  static constexpr std::string_view name = "hungriest_nonexempt";
  static constexpr std::string_view source = "paper, Sec. \"Predator Death\"; silent on the measure of age: released code's";

  [[nodiscard]] std::vector<BodyIndex> victims(const View& view, const IsExempt& is_exempt, OneSpecies only = {}) const {
    const auto hunters = detail::by_hunger(view, only);
    const auto dying = std::ranges::find_if_not(hunters, is_exempt);
    return dying != hunters.end() ? std::vector{*dying} : std::vector<BodyIndex>{};
  }
};
static_assert(Choice<HungriestNonexempt>);

}  // namespace trophic::death::starvation::choice
