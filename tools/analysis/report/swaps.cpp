// SPDX-License-Identifier: MIT
// Definitions of swaps.hpp.
#include <tools/analysis/report/swaps.hpp>

namespace trophic::analysis {

bool needs_shadow(const MetricName& name) {
  return name.metric.starts_with("attribution") || name.metric.starts_with("velocity");
}

std::vector<SwapEffect> effects_of(const std::string& swap, std::span<const SetDifference> differences) {
  std::vector<SwapEffect> effects;
  for (const SetDifference& d : differences) {
    const bool over_shadow = needs_shadow(d.name) && d.over_shadow.value.has_value();
    Difference difference = over_shadow ? d.over_shadow : d.raw;
    difference.adjusted.reset();
    effects.push_back({swap, d.name, over_shadow, d.a, d.b, difference});
  }
  return effects;
}

void adjust_together(std::vector<SwapEffect>& effects) {
  std::vector<Difference*> together;
  for (SwapEffect& effect : effects) together.push_back(&effect.difference);
  adjust_together(together);
}

}  // namespace trophic::analysis
