// SPDX-License-Identifier: MIT
// Results for machines: summary.json.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <trophic/analysis/metrics/run_set.hpp>
#include <trophic/analysis/report/claim_verdict.hpp>
#include <trophic/analysis/report/compare_sets.hpp>
#include <trophic/analysis/report/summary.hpp>

namespace trophic::analysis {

namespace detail {

[[nodiscard]] inline nlohmann::ordered_json to_json(const std::optional<double>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

inline void put(nlohmann::ordered_json& object, const std::optional<Interval>& interval) {
  object["lower"] = interval ? nlohmann::ordered_json(interval->lower) : nlohmann::ordered_json();
  object["upper"] = interval ? nlohmann::ordered_json(interval->upper) : nlohmann::ordered_json();
}

inline void put(nlohmann::ordered_json& object, const Estimate& estimate) {
  object["runs"] = estimate.runs;
  object["mean"] = to_json(estimate.mean);
  object["deviation"] = to_json(estimate.deviation);
  put(object, estimate.interval);
}

inline void put(nlohmann::ordered_json& object, const MetricName& name) {
  object["metric"] = name.metric;
  object["species"] = name.species;
  object["group"] = name.group;
  object["unit"] = name.unit;
}

inline void put(nlohmann::ordered_json& object, const Difference& difference) {
  object["value"] = to_json(difference.value);
  put(object, difference.interval);
  object["p"] = to_json(difference.p);
  object["p_adjusted"] = to_json(difference.adjusted);
  object["differs"] = difference.adjusted ? nlohmann::ordered_json(difference.differs()) : nlohmann::ordered_json();
}

[[nodiscard]] inline nlohmann::ordered_json runs_json(const RunSet& set) {
  nlohmann::ordered_json runs = nlohmann::ordered_json::array();
  for (const RunManifest& manifest : set.manifests) {
    runs.push_back({{"folder", std::filesystem::absolute(manifest.folder).lexically_normal().string()},
                    {"seed", manifest.seed},
                    {"status", manifest.status},
                    {"half_side_m", manifest.half_side_m},
                    {"until_s", manifest.until_s}});
  }
  return runs;
}

}  // namespace detail

/// Verdicts on published claims as JSON, one flat object a claim.
[[nodiscard]] inline nlohmann::ordered_json claims_json(std::span<const ClaimVerdict> verdicts) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const ClaimVerdict& each : verdicts) {
    nlohmann::ordered_json claim;
    detail::put(claim, metric_of(each.claim));
    claim["published"] = each.claim.value;
    claim["margin"] = each.claim.margin;
    claim["source"] = enum_name(each.claim.source);
    claim["second_line"] = each.claim.second_line;
    detail::put(claim, each.ours);
    claim["verdict"] = enum_name(each.verdict);
    claim["runs_needed"] = each.runs_needed ? nlohmann::ordered_json(*each.runs_needed) : nlohmann::ordered_json();
    json.push_back(claim);
  }
  return json;
}

/// A set as JSON: its runs, for each metric the mean with spread and 95 % interval, the paper's value and every baseline, and the
/// verdict on every published claim. null is what could not be computed. Baselines that are no null have no verdict.
[[nodiscard]] inline nlohmann::ordered_json summary_json(const ShadowedSet& set, std::span<const SummaryRow> rows) {
  nlohmann::ordered_json json;
  json["set"] = set.ours.label;
  json["backend"] = set.ours.manifests.front().backend;
  json["fingerprint"] = set.ours.manifests.front().fingerprint;
  json["runs_for_verdict"] = runs_for_verdict;
  json["runs"] = detail::runs_json(set.ours);
  json["shadow_runs"] = set.shadow ? detail::runs_json(*set.shadow) : nlohmann::ordered_json::array();
  for (const SummaryRow& row : rows) {
    nlohmann::ordered_json metric;
    detail::put(metric, row.name);
    detail::put(metric, row.ours);
    metric["published"] = detail::to_json(row.published);
    metric["baselines"] = nlohmann::ordered_json::array();
    for (const Comparison& comparison : row.comparisons) {
      nlohmann::ordered_json baseline;
      baseline["name"] = comparison.baseline;
      baseline["role"] = enum_name(comparison.role);
      baseline["value"] = detail::to_json(comparison.value);
      baseline["difference"] = detail::to_json(comparison.difference);
      detail::put(baseline, comparison.interval);
      baseline["verdict"] =
          comparison.role == Role::null ? nlohmann::ordered_json(enum_name(comparison.verdict())) : nlohmann::ordered_json();
      metric["baselines"].push_back(baseline);
    }
    json["metrics"].push_back(metric);
  }
  json["claims"] = claims_json(judge_claims(set.ours.runs));
  json["remarks"] = set.ours.remarks;
  if (set.shadow) {
    for (const std::string& remark : set.shadow->remarks) json["remarks"].push_back(remark);
  }
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
    detail::put(entry["raw"], d.raw);
    detail::put(entry["over_shadow"], d.over_shadow);
    json.push_back(entry);
  }
  return json;
}

}  // namespace trophic::analysis
