// SPDX-License-Identifier: MIT
// The paper's Tag Ratio input, over the whole population.
#pragma once

#include <trophic/perception/sensors/contract.hpp>

namespace trophic::perception::sensors {

/// Rule: TR = (P - N/2) / N, where P of all N robots show tag +1 (Sec. "Inputs", Eq. 2); in [-1/2, 1/2].   Reads: all
/// tags.   Random draws: 0.
struct TagRatioOfAll {
  static constexpr std::string_view name = "tag_ratio_of_all";
  static constexpr std::string_view source = "paper, Sec. \"Inputs\", Eq. 2";
  static constexpr std::size_t size = 1;
  static constexpr double least = -0.5;
  static constexpr double most = 0.5;
  [[nodiscard]] std::array<double, size> sense(const View& view) const {
    const auto total = static_cast<double>(std::ranges::count_if(view.robots, &Individual::lives));
    const auto is_positive = [](const Individual& one) { return one.lives() && one.tag == 1; };
    const auto positive = static_cast<double>(std::ranges::count_if(view.robots, is_positive));
    return {(positive - total / 2.0) / total};
  }
};
static_assert(CommonSensor<TagRatioOfAll>);

}  // namespace trophic::perception::sensors
