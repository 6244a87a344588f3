// SPDX-License-Identifier: MIT
// The hungriest predator that is not exempt starves; the hungriest of all if all are exempt.
#pragma once

#include <trophic/death/starvation/choice/contract.hpp>
#include <trophic/death/starvation/choice/detail/by_hunger.hpp>

namespace trophic::death::starvation::choice {

/// Rule (released code): like HungriestNonexempt, but if all hunters are exempt, the hungriest dies anyway, so every procedure
/// has a victim.   Reads: hunger, ids.   Random draws: 0.
struct HungriestNonexemptElseHungriest {
  static constexpr std::string_view name = "hungriest_nonexempt_else_hungriest";
  static constexpr std::string_view source = "released code";

  [[nodiscard]] std::vector<BodyIndex> victims(const View& view, const IsExempt& is_exempt, OneSpecies only = {}) const {
    const auto hunters = detail::by_hunger(view, only);
    if (hunters.empty()) return {};
    const auto dying = std::ranges::find_if_not(hunters, is_exempt);
    return {dying != hunters.end() ? *dying : hunters.front()};
  }
};
static_assert(Choice<HungriestNonexemptElseHungriest>);

}  // namespace trophic::death::starvation::choice
