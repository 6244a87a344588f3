// SPDX-License-Identifier: MIT
// Definitions of own_column.hpp.
#include <tools/analysis/metrics/own_column.hpp>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <tools/analysis/data/csv_reader.hpp>
#include <tools/analysis/metrics/series.hpp>
#include <utility>

namespace trophic::analysis {

namespace {

constexpr double curve_window_s = 200.0;

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
  std::vector<std::pair<MetricName, WindowMean>> found;
  if (!places[1] && !places[2]) found.emplace_back(MetricName{column.column, "", "all", column.unit}, WindowMean{curve_window_s});
  while (table.next()) {
    const double time_s = places[0] ? table.get<double>(*places[0]) : 0.0;
    if (time_s > run.manifest.until_s) continue;
    const MetricName name{column.column, places[1] ? table.get<std::string>(*places[1]) : "",
                          places[2] ? table.get<std::string>(*places[2]) : "all", column.unit};
    auto place = std::ranges::find(found, name, &std::pair<MetricName, WindowMean>::first);
    if (place == found.end()) place = found.insert(found.end(), {name, WindowMean{curve_window_s}});
    place->second.add(time_s, is_nan(table.text(0)) ? std::nullopt : std::optional{table.get<double>(0)});
  }
  detail::remark_truncated(table, path, remarks);
  for (const auto& [name, mean] : found) {
    if (std::ranges::find(result.measurements, name, &Measurement::name) != result.measurements.end()) {
      throw std::invalid_argument{"--column " + column.file + ":" + column.column +
                                  ": trophic has a metric of this name; rename the column"};
    }
    if (!mean.mean()) remarks.push_back(path.string() + ": " + column.column + " has no value; the run is left out of its mean");
    result.measurements.push_back({name, mean.mean(), {}});
    if (places[0]) result.curves.push_back({name, "", mean.series()});
  }
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
