// SPDX-License-Identifier: MIT
// Results for machines: metrics.csv and summary.json.
#pragma once

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <trophic/measure/run_set.hpp>
#include <trophic/measure/summary.hpp>
#include <trophic/observe/csv.hpp>

namespace trophic::measure {

/// Writes every measurement and every curve of every run, one value a row. Columns: set, run, seed, metric, species, group,
/// baseline (empty: observed), time_s (of a curve, the end of its window; empty: of the whole run), value (empty: could not be
/// computed), unit. Throws std::runtime_error if the file exists or cannot be written.
inline void write_metrics(const std::filesystem::path& path, std::span<const RunSet> sets) {
  observe::CsvFile file{path, "set,run,seed,metric,species,group,baseline,time_s,value,unit"};
  for (const RunSet& set : sets) {
    for (std::size_t i = 0; i < set.runs.size(); ++i) {
      std::string run = set.facts[i].folder.lexically_normal().filename().string();
      std::ranges::replace(run, ',', '_');
      const auto row = [&](const MetricName& name, const std::string& baseline, std::optional<double> time_s,
                           std::optional<double> value) {
        file.row(set.label, run, set.facts[i].seed, name.metric, name.species, name.group, baseline, time_s, value, name.unit);
      };
      for (const Measurement& measurement : set.runs[i].measurements) {
        row(measurement.name, "", {}, measurement.value);
        for (const Baseline& baseline : measurement.baselines) row(measurement.name, baseline.name, {}, baseline.value);
      }
      for (const Curve& curve : set.runs[i].curves) {
        for (const Point& point : curve.points) row(curve.name, curve.baseline, point.time_s, point.value);
      }
      file.flush();
    }
  }
}

namespace detail {

[[nodiscard]] inline nlohmann::ordered_json to_json(const std::optional<double>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

inline void put(nlohmann::ordered_json& object, const Estimate& estimate) {
  object["runs"] = estimate.runs;
  object["mean"] = to_json(estimate.mean);
  object["lower"] = estimate.interval ? nlohmann::ordered_json(estimate.interval->lower) : nlohmann::ordered_json();
  object["upper"] = estimate.interval ? nlohmann::ordered_json(estimate.interval->upper) : nlohmann::ordered_json();
}

inline void put(nlohmann::ordered_json& object, const MetricName& name) {
  object["metric"] = name.metric;
  object["species"] = name.species;
  object["group"] = name.group;
  object["unit"] = name.unit;
}

}  // namespace detail

/// A set as JSON: its runs, and for each metric the mean with its 95 % interval, the paper's value and every baseline. null is
/// what could not be computed.
[[nodiscard]] inline nlohmann::ordered_json summary_json(const RunSet& set, std::span<const SummaryRow> rows) {
  nlohmann::ordered_json json;
  json["set"] = set.label;
  json["backend"] = set.facts.front().backend;
  json["fingerprint"] = set.facts.front().fingerprint;
  for (const RunFacts& facts : set.facts) {
    json["runs"].push_back({{"folder", std::filesystem::absolute(facts.folder).lexically_normal().string()},
                            {"seed", facts.seed},
                            {"status", facts.status},
                            {"half_side_m", facts.half_side_m},
                            {"until_s", facts.until_s}});
  }
  for (const SummaryRow& row : rows) {
    nlohmann::ordered_json metric;
    detail::put(metric, row.name);
    detail::put(metric, row.ours);
    metric["published"] = detail::to_json(row.published);
    metric["baselines"] = nlohmann::ordered_json::array();
    for (const Comparison& comparison : row.comparisons) {
      nlohmann::ordered_json baseline;
      baseline["name"] = comparison.baseline;
      baseline["of_paper"] = comparison.of_paper;
      baseline["value"] = detail::to_json(comparison.value);
      baseline["verdict"] = enum_name(comparison.verdict());
      detail::put(baseline["difference"], comparison.difference);
      metric["baselines"].push_back(baseline);
    }
    metric["changes_conclusion"] = nlohmann::ordered_json::array();
    for (const Comparison* null : row.contradictions()) metric["changes_conclusion"].push_back(null->baseline);
    json["metrics"].push_back(metric);
  }
  json["remarks"] = set.remarks;
  return json;
}

/// Differences of two sets as JSON.
[[nodiscard]] inline nlohmann::ordered_json differences_json(std::span<const SetDifference> differences) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const SetDifference& d : differences) {
    nlohmann::ordered_json entry;
    detail::put(entry, d.name);
    detail::put(entry["a"], d.a);
    detail::put(entry["b"], d.b);
    entry["difference"] = detail::to_json(d.difference);
    entry["lower"] = d.interval ? nlohmann::ordered_json(d.interval->lower) : nlohmann::ordered_json();
    entry["upper"] = d.interval ? nlohmann::ordered_json(d.interval->upper) : nlohmann::ordered_json();
    entry["verdict"] = enum_name(verdict(d.interval));
    json.push_back(entry);
  }
  return json;
}

}  // namespace trophic::measure
