// SPDX-License-Identifier: MIT
// The hungriest predator starves.
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <string_view>
#include <trophic/death/starvation/contract.hpp>
#include <trophic/params/params.hpp>
#include <tuple>
#include <vector>

namespace trophic::death::starvation {

/// Rule: of all hunters the one with the highest hunger (ticks since birth or last catch) dies, unless it is spared; then
/// the next hungriest (Sec. "Predator Death"). Ties: the earlier born first. If all are spared nobody dies, or, as in the
/// released code, the hungriest all the same. Reads: hunger, ids.   Random draws: 0.
struct HungriestStarves {
  static constexpr std::string_view name = "hungriest_starves";

  struct Params {
    bool even_if_all_spared = false;
    static constexpr auto fields() {
      return std::tuple{field("even_if_all_spared", &Params::even_if_all_spared, "the hungriest dies if everybody is spared")};
    }
  };
  Params params;

  [[nodiscard]] std::optional<BodyIndex> victim(const View& view, const std::function<bool(BodyIndex)>& spared) const {
    std::vector<BodyIndex> hunters;
    for (BodyIndex body = 0; body < view.robots.size(); ++body) {
      if (view.web.hunts(view.robots[body].species)) hunters.push_back(body);
    }
    if (hunters.empty()) return std::nullopt;
    std::ranges::sort(hunters, [&](BodyIndex a, BodyIndex b) {
      const Individual& first = view.robots[a];
      const Individual& second = view.robots[b];
      return first.fed_tick != second.fed_tick ? first.fed_tick < second.fed_tick : first.id < second.id;
    });
    const auto dying = std::ranges::find_if_not(hunters, spared);
    if (dying != hunters.end()) return *dying;
    return params.even_if_all_spared ? std::optional{hunters.front()} : std::nullopt;
  }
};
static_assert(Starvation<HungriestStarves>);

}  // namespace trophic::death::starvation
