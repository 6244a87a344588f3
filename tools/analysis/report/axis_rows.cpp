// SPDX-License-Identifier: MIT
// Definitions of axis_rows.hpp.
#include <tools/analysis/report/axis_rows.hpp>

#include <cmath>
#include <tools/analysis/report/columns.hpp>
#include <tools/analysis/report/reading.hpp>
#include <tools/analysis/report/table_file.hpp>

namespace trophic::analysis {

AxisEffectRow row_of(const AxisEffect& of) {
  const Difference& d = of.difference;
  return {.axis = of.axis,
          .value = of.value,
          .reference = of.reference,
          .metric = of.name.metric,
          .species = of.name.species,
          .group = of.name.group,
          .unit = of.name.unit,
          .compared = of.over_shadow ? "over_shadow" : "raw",
          .settings = of.settings,
          .seeds = of.seeds,
          .mean = of.mean,
          .mean_reference = of.mean_reference,
          .difference = d.value,
          .lower = lower_of(d.interval),
          .upper = upper_of(d.interval),
          .p = d.p,
          .p_holm = d.adjusted,
          .significant = significance_text(d)};
}

void write_axis_effects(const std::filesystem::path& path, std::span<const AxisEffect> effects) {
  TableFile<AxisEffectRow> file{path};
  for (const AxisEffect& effect : effects) file.write(row_of(effect));
  file.finish();
}

void print_axis_effects(std::ostream& out, std::span<const AxisEffect> effects) {
  if (effects.empty()) return;
  std::size_t significant = 0;
  std::vector<const AxisEffect*> largest;
  for (const AxisEffect& effect : effects) {
    if (!effect.difference.differs()) continue;
    ++significant;
    const auto found = std::ranges::find_if(
        largest, [&](const AxisEffect* other) { return other->axis == effect.axis && other->name == effect.name; });
    if (found == largest.end()) {
      largest.push_back(&effect);
    } else if (std::abs(*effect.difference.value) > std::abs(*(*found)->difference.value)) {
      *found = &effect;
    }
  }
  out << "averaged over the other axes, " << significant << " of " << effects.size()
      << " effects of an axis are significant (Holm)";
  if (largest.empty()) {
    out << "\n";
    return;
  }
  out << "; the largest of each:\n";
  constexpr std::size_t shown = 20;
  Columns columns{{"effect of an axis", "difference [95 %]", "axis", "values"}};
  for (std::size_t i = 0; i < std::min(shown, largest.size()); ++i) {
    const AxisEffect& effect = *largest[i];
    const Reading reading{effect.name};
    columns.add({metric_title(effect.name) + (effect.over_shadow ? ", over shadow" : ""),
                 reading.with_interval(effect.difference.value, effect.difference.interval, true), effect.axis,
                 effect.reference + " -> " + effect.value});
  }
  columns.print(out);
  if (largest.size() > shown) out << "and " << largest.size() - shown << " more: significant in sweep_effects.csv\n";
}

}  // namespace trophic::analysis
