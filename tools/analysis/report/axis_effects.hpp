// SPDX-License-Identifier: MIT
// The effect of each value of an axis, averaged over the rest of the grid: all cells count.
#pragma once

#include <cstddef>
#include <tools/analysis/data/sweep_grid.hpp>
#include <tools/analysis/metrics/measurement.hpp>
#include <tools/analysis/metrics/sweep_values.hpp>
#include <tools/analysis/statistics/difference.hpp>

namespace trophic::analysis {

/// One metric with an axis at one value, compared with the axis at the reference cell's value.
struct AxisEffect {
  std::string axis;
  std::string value;
  std::string reference;  ///< the axis' value in the reference cell
  MetricName name;
  bool over_shadow = false;
  std::size_t settings = 0;  ///< of the other axes, at which both cells are in the grid
  std::size_t seeds = 0;     ///< with a value in all of these cells
  std::optional<double> mean;
  std::optional<double> mean_reference;
  Difference difference;  ///< mean - mean_reference; p corrected for all effects of the sweep (Holm)
};

/// For every axis, each of its values but the reference cell's, and each of `names`: the mean over all settings of the other axes
/// at which both values were run, one number a seed, and Student's t over seeds. Over the shadows where the metric needs it and
/// all of these cells have them. Empty if the cells do not share their seeds, as then no seed is in all of them.
[[nodiscard]] std::vector<AxisEffect> axis_effects(const SweepGrid& grid, const SweepValues& values, std::size_t reference,
                                                   std::span<const MetricName> names);

}  // namespace trophic::analysis
