// SPDX-License-Identifier: MIT
// The released code's Tag Ratio input, over active robots.
#pragma once

#include <trophic/perception/sensors/contract.hpp>

namespace trophic::perception::sensors {

/// Rule: TR = (P - N/2) / N, where P of the N active robots show tag +1 (released code); 0 if no robot is active. Reads: all
/// tags and activities.   Random draws: 0.
struct TagRatioOfActive {
  static constexpr std::string_view name = "tag_ratio_of_active";
  static constexpr std::string_view source = "released code";
  static constexpr std::size_t size = 1;
  static constexpr double least = -0.5;
  static constexpr double most = 0.5;
  [[nodiscard]] std::array<double, size> sense(const View& view) const {
    double total = 0.0;
    double positive = 0.0;
    for (const Individual& individual : view.robots) {
      if (!individual.active) continue;
      total += 1.0;
      if (individual.tag == 1) positive += 1.0;
    }
    return {total > 0.0 ? (positive - total / 2.0) / total : 0.0};
  }
};
static_assert(CommonSensor<TagRatioOfActive>);

}  // namespace trophic::perception::sensors
