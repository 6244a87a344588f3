// SPDX-License-Identifier: MIT
// The hungriest predator that is not spared starves; nobody if all are spared.
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <string_view>
#include <trophic/death/starvation/contract.hpp>
#include <trophic/death/starvation/detail/by_hunger.hpp>

namespace trophic::death::starvation {

/// Rule: of all hunters the one with the highest hunger (ticks since birth or last catch) dies, unless it is spared; then the
/// next hungriest. The text has "the next oldest predator dies" (Sec. "Predator Death"), here read as the next hungriest, as the
/// released code does; HungriestElseOldest reads it as written. Ties: the earlier born first. If all are spared none dies;
/// HungriestUnsparedElseHungriest is the released code's.   Reads: hunger, ids.   Random draws: 0.
struct HungriestUnspared {
  static constexpr std::string_view name = "hungriest_unspared";
  static constexpr std::string_view source = "paper, Sec. \"Predator Death\"; silent on the measure of age: released code's";

  [[nodiscard]] std::optional<BodyIndex> victim(const View& view, const std::function<bool(BodyIndex)>& spared) const {
    const auto hunters = detail::by_hunger(view);
    const auto dying = std::ranges::find_if_not(hunters, spared);
    return dying != hunters.end() ? std::optional{*dying} : std::nullopt;
  }
};
static_assert(Starvation<HungriestUnspared>);

}  // namespace trophic::death::starvation
