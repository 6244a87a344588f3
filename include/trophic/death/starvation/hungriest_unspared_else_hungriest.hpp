// SPDX-License-Identifier: MIT
// The hungriest predator that is not spared starves; the hungriest of all if all are spared.
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <string_view>
#include <trophic/death/starvation/contract.hpp>
#include <trophic/death/starvation/detail/by_hunger.hpp>

namespace trophic::death::starvation {

/// Rule (released code): as HungriestUnspared, but if all hunters are spared the hungriest dies all the same: a procedure always
/// has a victim.   Reads: hunger, ids.   Random draws: 0.
struct HungriestUnsparedElseHungriest {
  static constexpr std::string_view name = "hungriest_unspared_else_hungriest";
  static constexpr std::string_view source = "released code";

  [[nodiscard]] std::optional<BodyIndex> victim(const View& view, const std::function<bool(BodyIndex)>& spared) const {
    const auto hunters = detail::by_hunger(view);
    if (hunters.empty()) return std::nullopt;
    const auto dying = std::ranges::find_if_not(hunters, spared);
    return dying != hunters.end() ? *dying : hunters.front();
  }
};
static_assert(Starvation<HungriestUnsparedElseHungriest>);

}  // namespace trophic::death::starvation
