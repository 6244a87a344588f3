// SPDX-License-Identifier: MIT
// The hungriest predator starves or, if it is exempt, the oldest one that is not.
#pragma once

#include <trophic/death/starvation/choice/contract.hpp>
#include <trophic/death/starvation/choice/detail/by_hunger.hpp>

namespace trophic::death::starvation::choice {

/// Rule: the hunter with the highest hunger dies (ties: the earlier born) unless it is exempt. Then the earliest born of all
/// hunters that are not exempt dies; ids are in order of birth. If all are exempt, none dies. The paper is ambiguous: this rule
/// takes *oldest* in "the next oldest predator dies" (Sec. "Predator Death") literally, as age; HungriestNonexempt reads it as
/// the longest time without a catch.   Reads: hunger, ids.   Random draws: 0.
struct HungriestElseOldest {
  static constexpr std::string_view name = "hungriest_else_oldest";
  static constexpr std::string_view source = "paper: silent; a reading of Sec. \"Predator Death\"";

  [[nodiscard]] std::vector<BodyIndex> victims(const View& view, const IsExempt& is_exempt, OneSpecies only = {}) const {
    auto hunters = detail::by_hunger(view, only);
    if (hunters.empty()) return {};
    std::ranges::sort(hunters.begin() + 1, hunters.end(), {}, [&](BodyIndex body) { return view.robots[body].id; });
    const auto dying = std::ranges::find_if_not(hunters, is_exempt);
    return dying != hunters.end() ? std::vector{*dying} : std::vector<BodyIndex>{};
  }
};
static_assert(Choice<HungriestElseOldest>);

}  // namespace trophic::death::starvation::choice
