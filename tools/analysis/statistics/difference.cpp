// SPDX-License-Identifier: MIT
// Definitions of difference.hpp.
#include <tools/analysis/statistics/difference.hpp>

#include <tools/analysis/statistics/holm.hpp>
#include <vector>

namespace trophic::analysis {

std::string significance_text(const Difference& difference) {
  if (!difference.adjusted) return "";
  return difference.differs() ? "yes" : "no";
}

std::optional<std::size_t> Difference::runs_needed() const {
  if (!level || !scatter || differs()) return std::nullopt;
  return runs_for_power(*value, *scatter, *level);
}

Difference difference_of(std::optional<double> value, const std::optional<Contrast>& of, const std::optional<Scatter>& scatter) {
  return {.value = value, .interval = interval_of(of), .p = p_value(of), .scatter = scatter};
}

void adjust_together(std::span<Difference* const> differences) {
  std::vector<double> p_values;
  for (const Difference* each : differences) {
    if (each->p) p_values.push_back(*each->p);
  }
  const std::vector<double> adjusted = holm(p_values);
  std::size_t k = 0;
  for (Difference* each : differences) {
    each->adjusted = each->p ? std::optional{adjusted[k++]} : std::nullopt;
    if (each->p) each->level = 0.05 / static_cast<double>(p_values.size());
  }
}

}  // namespace trophic::analysis
