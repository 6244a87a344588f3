// SPDX-License-Identifier: MIT
// Definitions of flips.hpp.
#include <tools/analysis/report/flips.hpp>

namespace trophic::analysis {

bool needs_shadow(const MetricName& name) {
  return name.metric.starts_with("attribution") || name.metric.starts_with("velocity");
}

std::vector<FlipEffect> effects_of(const std::string& flip, std::span<const SetDifference> differences) {
  std::vector<FlipEffect> effects;
  for (const SetDifference& d : differences) {
    const bool over_shadow = needs_shadow(d.name) && d.over_shadow.value.has_value();
    Difference difference = over_shadow ? d.over_shadow : d.raw;
    difference.adjusted.reset();
    effects.push_back({flip, d.name, over_shadow, d.a, d.b, difference});
  }
  return effects;
}

void adjust_together(std::vector<FlipEffect>& effects) {
  std::vector<Difference*> together;
  for (FlipEffect& effect : effects) together.push_back(&effect.difference);
  adjust_together(together);
}

}  // namespace trophic::analysis
