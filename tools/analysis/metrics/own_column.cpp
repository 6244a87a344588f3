// SPDX-License-Identifier: MIT
// Definitions of own_column.hpp.
#include <tools/analysis/metrics/own_column.hpp>

#include <tools/analysis/metrics/sampled_metric.hpp>
#include <tools/reading/csv_reader.hpp>

namespace trophic::analysis {

namespace {

bool is_nan(std::string_view cell) {
  return cell.empty() || cell == "nan" || cell == "-nan" || cell == "NaN" || cell == "NA";
}

}  // namespace

OwnColumn own_column_of(std::string_view text) {
  const auto refuse = [&] {
    throw std::invalid_argument{"--column " + std::string{text} + ": must be FILE:COLUMN or FILE:COLUMN:UNIT"};
  };
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) refuse();
  OwnColumn column{.file = std::string{text.substr(0, colon)}, .column = std::string{text.substr(colon + 1)}};
  if (const std::size_t second = column.column.find(':'); second != std::string::npos) {
    column.unit = column.column.substr(second + 1);
    column.column.resize(second);
  }
  if (column.column.empty() || column.unit.empty() || column.unit.find(':') != std::string::npos) refuse();
  if (column.file.empty() || std::filesystem::path{column.file}.has_parent_path()) {
    throw std::invalid_argument{"--column " + std::string{text} + ": must name a file in each run's folder, without a path"};
  }
  return column;
}

void measure_column(const OwnColumn& column, const RunData& run, RunMetrics& result, std::vector<std::string>& remarks) {
  const std::filesystem::path path = run.manifest.folder / column.file;
  if (!std::filesystem::exists(path)) {
    throw std::invalid_argument{"--column " + column.file + ":" + column.column + ": " + run.manifest.folder.string() +
                                " has no such file"};
  }
  CsvReader table{path, {column.column}};
  detail::check_sum(table, path, run.manifest.tables);
  std::vector<std::optional<std::size_t>> places;
  for (const char* name : {"time_s", "species", "group"}) {
    if (table.has(name)) table.want(name);
    places.push_back(table.has(name) ? std::optional{table.place_of(name)} : std::nullopt);
  }
  SampledMetric found{column.column, column.unit, !places[1] && !places[2]};
  while (table.next()) {
    const std::optional<double> time_s = places[0] ? std::optional{table.get<double>(*places[0])} : std::nullopt;
    if (time_s.value_or(0.0) > run.manifest.until_s) continue;
    found.add(places[1] ? table.get<std::string>(*places[1]) : "", places[2] ? table.get<std::string>(*places[2]) : "all", time_s,
              is_nan(table.text(0)) ? std::nullopt : std::optional{table.get<double>(0)});
  }
  detail::remark_truncated(table, path, remarks);
  found.finish("--column " + column.file + ":" + column.column, path.string(), result, remarks);
}

void give_all_the_same_columns(std::span<RunMetrics* const> runs) {
  std::vector<MetricName> all;
  for (const RunMetrics* run : runs) {
    for (const Measurement& each : run->measurements) {
      if (std::ranges::find(all, each.name) == all.end()) all.push_back(each.name);
    }
  }
  for (RunMetrics* run : runs) {
    std::vector<Measurement> whole;
    for (const MetricName& name : all) {
      const auto found = std::ranges::find(run->measurements, name, &Measurement::name);
      whole.push_back(found == run->measurements.end() ? Measurement{name, {}, {}} : *found);
    }
    run->measurements = std::move(whole);
  }
}

}  // namespace trophic::analysis
