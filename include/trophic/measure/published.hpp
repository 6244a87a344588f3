// SPDX-License-Identifier: MIT
// What the paper published, to set ours beside.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <trophic/measure/run_metrics.hpp>

namespace trophic::measure {

/// The paper's mean over its ten runs. Velocities are positive towards the adversary; the paper does not say of which group its
/// mean velocities are, they are given for all. None for what it did not publish.
[[nodiscard]] inline std::optional<double> published(const MetricName& name) {
  struct Value {
    std::string_view metric;
    std::string_view species;
    std::string_view group;
    double value;
  };
  static constexpr std::array<Value, 8> values{{
      {"attribution_caught", "prey", "all", 0.65},
      {"attribution_catches", "predator", "all", 0.725},
      {"velocity", "predator", "all", 0.0195},
      {"velocity", "prey", "all", -0.0067},
      {"wall_sticking", "predator", "all", 0.39},
      {"wall_sticking", "prey", "all", 0.60},
      {"wall_sticking_gap", "prey-predator", "all", 0.21},
      {"tag_symmetry", "prey+predator", "inherited", 0.43},
  }};
  for (const Value& value : values) {
    if (value.metric == name.metric && value.species == name.species && value.group == name.group) return value.value;
  }
  return std::nullopt;
}

}  // namespace trophic::measure
