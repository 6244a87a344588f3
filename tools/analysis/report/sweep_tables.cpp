// SPDX-License-Identifier: MIT
// Definitions of sweep_tables.hpp.
#include <tools/analysis/report/sweep_tables.hpp>

#include <tools/analysis/report/table_file.hpp>
#include <tools/analysis/statistics/estimate.hpp>
#include <tools/sweep/plan_file.hpp>
#include <trophic/io/csv.hpp>
#include <trophic/population/food_web.hpp>
#include <trophic/support/new_file.hpp>

namespace trophic::analysis::detail {

std::vector<double> numbers(const std::map<std::uint64_t, double>& by_seed) {
  std::vector<double> values;
  for (const auto& [seed, value] : by_seed) values.push_back(value);
  return values;
}

SweepMetricRow metric_row(std::size_t cell, const MetricName& name, const CellValues& values) {
  const Estimate raw = estimate(numbers(values.raw));
  const Estimate over = estimate(numbers(values.over_shadow));
  SweepMetricRow row{.cell = cell, .metric = name.metric, .species = name.species, .group = name.group, .unit = name.unit};
  row.runs = raw.runs;
  row.mean = raw.mean;
  row.deviation = raw.deviation;
  row.lower = lower_of(raw.interval);
  row.upper = upper_of(raw.interval);
  row.shadow_runs = values.shadow.size();
  row.shadow = mean_of(numbers(values.shadow));
  row.pairs = over.runs;
  row.over_shadow = over.mean;
  row.over_lower = lower_of(over.interval);
  row.over_upper = upper_of(over.interval);
  return row;
}

std::size_t runs_there(const SweepRuns& sweep, const GridCell& cell, std::optional<std::size_t> GridReplicate::*kind) {
  return static_cast<std::size_t>(std::ranges::count_if(
      cell.replicates, [&](const GridReplicate& replicate) { return replicate.*kind && sweep.is_there[*(replicate.*kind)]; }));
}

}  // namespace trophic::analysis::detail

namespace trophic::analysis {

void write_cells(const std::filesystem::path& path, const SweepRuns& sweep, std::optional<double> until_s) {
  std::vector<const Axis*> settings;
  std::string text = io::header_of<CellRow>();
  text.pop_back();
  for (const Axis& axis : sweep.grid.axes) {
    if (axis.name == "rule_table" || axis.name == "engine") continue;
    settings.push_back(&axis);
    text += ',';
    io::detail::append_cell(text, axis.name);
  }
  text += '\n';
  for (std::size_t i = 0; i < sweep.grid.cells.size(); ++i) {
    const GridCell& cell = sweep.grid.cells[i];
    const sweep::PlannedRun& run = sweep.plan[cell.first];
    const auto planned = std::ranges::count_if(cell.replicates, [](const GridReplicate& one) { return one.run.has_value(); });
    const CellRow row{.cell = cell.number,
                      .rule_table = run.rule_table,
                      .engine = run.engine,
                      .runs = detail::runs_there(sweep, cell, &GridReplicate::run),
                      .runs_planned = static_cast<std::size_t>(planned),
                      .shadow_runs = detail::runs_there(sweep, cell, &GridReplicate::shadow),
                      .until_s = until_s.value_or(run.until_s)};
    io::append_row(text, row, FoodWeb{{}, {}});
    text.pop_back();
    for (const Axis* axis : settings) {
      text += ',';
      io::detail::append_cell(text, axis->values[i]);
    }
    text += '\n';
  }
  write_new_file(path, text);
}

void write_runs(const std::filesystem::path& path, const SweepRuns& sweep, const SweepValues& values) {
  TableFile<SweepRunRow> file{path};
  for (const sweep::PlannedRun& run : sweep.plan) {
    for (std::size_t m = 0; m < values.names.size(); ++m) {
      const auto value = values.value(run.index, m);
      if (!value) continue;
      file.write({.run = run.index,
                  .cell = run.cell,
                  .replicate = run.replicate,
                  .shadow = run.shadow,
                  .seed = run.seed,
                  .metric = values.names[m].metric,
                  .species = values.names[m].species,
                  .group = values.names[m].group,
                  .value = *value});
    }
    file.flush();
  }
  file.finish();
}

void write_sweep_metrics(const std::filesystem::path& path, const SweepGrid& grid, const SweepValues& values) {
  TableFile<SweepMetricRow> file{path};
  for (const GridCell& cell : grid.cells) {
    for (std::size_t m = 0; m < values.names.size(); ++m) {
      file.write(detail::metric_row(cell.number, values.names[m], cell_values(cell, values, m)));
    }
    file.flush();
  }
  file.finish();
}

void write_sweep_differences(const std::filesystem::path& path, const CellDifferences& differences, std::size_t reference) {
  TableFile<SweepDifferenceRow> file{path};
  for (const CellDifference& each : differences.all) file.write(row_of(each, reference));
  file.finish();
}

}  // namespace trophic::analysis
