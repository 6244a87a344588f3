// SPDX-License-Identifier: MIT
// sweep_effects.csv, and the significant effects for people.
#pragma once

#include <filesystem>
#include <ostream>
#include <span>
#include <tools/analysis/report/axis_effects.hpp>
#include <trophic/io/column.hpp>

namespace trophic::analysis {

/// sweep_effects.csv: one row a metric at a value of an axis.
struct AxisEffectRow {
  std::string axis = {};
  std::string value = {};
  std::string reference = {};
  std::string metric = {};
  std::string species = {};
  std::string group = {};
  std::string unit = {};
  std::string compared = {};
  std::size_t settings = 0;
  std::size_t seeds = 0;
  std::optional<double> mean = {};
  std::optional<double> mean_reference = {};
  std::optional<double> difference = {};
  std::optional<double> lower = {};
  std::optional<double> upper = {};
  std::optional<double> p = {};
  std::optional<double> p_holm = {};
  std::string significant = {};

  static constexpr auto columns() {
    using io::column;
    return std::tuple{
        column("axis", &AxisEffectRow::axis, "", "what varies: a setting's path, rule_table or engine"),
        column("value", &AxisEffectRow::value, "", "its value here"),
        column("reference", &AxisEffectRow::reference, "", "its value in the reference cell"),
        column("metric", &AxisEffectRow::metric, "", "what was measured"),
        column("species", &AxisEffectRow::species, "", "of whom; of a metric of two: prey+predator"),
        column("group", &AxisEffectRow::group, "", "as in metrics.csv"),
        column("unit", &AxisEffectRow::unit, "", "of means, differences and intervals"),
        column("compared", &AxisEffectRow::compared, "", "raw, or over_shadow: each run over its shadow first"),
        column("settings", &AxisEffectRow::settings, "", "of the other axes, over which was averaged"),
        column("seeds", &AxisEffectRow::seeds, "", "with a value in all of these cells"),
        column("mean", &AxisEffectRow::mean, "", "with the axis at this value, over settings and seeds"),
        column("mean_reference", &AxisEffectRow::mean_reference, "", "with the axis at the reference cell's value"),
        column("difference", &AxisEffectRow::difference, "", "mean - mean_reference"),
        column("lower", &AxisEffectRow::lower, "", "of this effect's own 95 % interval, over seeds; empty for fewer than 6"),
        column("upper", &AxisEffectRow::upper, "", "of this effect's own 95 % interval"),
        column("p", &AxisEffectRow::p, "", "of this effect alone"),
        column("p_holm", &AxisEffectRow::p_holm, "", "corrected for all effects of the analysis"),
        column("significant", &AxisEffectRow::significant, "", "yes where p_holm <= 0.05, else no; empty without a p value")};
  }
};

[[nodiscard]] AxisEffectRow row_of(const AxisEffect& of);

/// Writes sweep_effects.csv. Throws std::runtime_error if it exists or cannot be written.
void write_axis_effects(const std::filesystem::path& path, std::span<const AxisEffect> effects);

/// One line for each axis and metric with a significant value, the value with the largest effect.
void print_axis_effects(std::ostream& out, std::span<const AxisEffect> effects);

}  // namespace trophic::analysis
