// SPDX-License-Identifier: MIT
// Definitions of sweep_rows.hpp.
#include <tools/analysis/report/sweep_rows.hpp>

#include <tools/analysis/statistics/interval.hpp>

namespace trophic::analysis {

SweepDifferenceRow row_of(const CellDifference& of, std::size_t reference) {
  const Difference& d = of.difference;
  return {.cell = of.cell,
          .reference = reference,
          .metric = of.name.metric,
          .species = of.name.species,
          .group = of.name.group,
          .unit = of.name.unit,
          .compared = of.over_shadow ? "over_shadow" : "raw",
          .design = of.paired ? "paired" : "independent",
          .runs = of.runs,
          .runs_reference = of.runs_reference,
          .mean = of.mean,
          .mean_reference = of.mean_reference,
          .difference = d.value,
          .lower = lower_of(d.interval),
          .upper = upper_of(d.interval),
          .lower_corrected = lower_of(of.corrected),
          .upper_corrected = upper_of(of.corrected),
          .p = d.p,
          .p_holm = d.adjusted,
          .significant = significance_text(d),
          .hedges_g = of.hedges_g,
          .runs_needed = of.runs_needed,
          .smallest_detectable = of.detectable};
}

}  // namespace trophic::analysis
