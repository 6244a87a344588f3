// SPDX-License-Identifier: MIT
// Results for machines: metrics.csv.
#pragma once

#include <cstdint>
#include <tools/analysis/metrics/run_set.hpp>
#include <trophic/io/column.hpp>

namespace trophic::analysis {

/// metrics.csv: every measurement and every curve of every run, one value a row.
struct MetricRow {
  std::string set = {};
  std::string run = {};
  std::uint64_t seed = 0;
  std::string metric = {};
  std::string species = {};
  std::string group = {};
  std::string baseline = {};
  std::optional<double> time_s = {};
  std::optional<double> value = {};
  std::string unit = {};

  static constexpr auto columns() {
    using io::column;
    return std::tuple{
        column("set", &MetricRow::set, "", "name of the rule table"),
        column("run", &MetricRow::run, "", "name of the run's folder"),
        column("seed", &MetricRow::seed, "", "of the run"),
        column("metric", &MetricRow::metric, "", "what was measured"),
        column("species", &MetricRow::species, "", "of whom; of a metric of two: prey+predator"),
        column("group", &MetricRow::group, "",
               "all, random, inherited, active (at that tick) or inherited_active; of deaths a cause, of ticks_at a number of "
               "members"),
        column("baseline", &MetricRow::baseline, "", "empty: observed; shadow: observed in the shadow of that seed"),
        column("time_s", &MetricRow::time_s, "s", "of a curve the end of its window; empty: of the whole run"),
        column("value", &MetricRow::value, "", "in `unit`; empty: could not be computed"),
        column("unit", &MetricRow::unit, "", "of the value; 1 for shares and counts")};
  }
};

/// Throws std::runtime_error if the file exists or cannot be written.
void write_metrics(const std::filesystem::path& path, std::span<const ShadowedSet> sets);

/// The same as a text.
[[nodiscard]] std::string metrics_text(std::span<const ShadowedSet> sets);

}  // namespace trophic::analysis
