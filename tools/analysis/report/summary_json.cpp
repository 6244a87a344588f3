// SPDX-License-Identifier: MIT
// Definitions of summary_json.hpp.
#include <tools/analysis/report/summary_json.hpp>

namespace trophic::analysis::detail {

Json to_json(const std::optional<double>& value) {
  return value ? Json(*value) : Json();
}

Json to_json(const std::optional<std::size_t>& count) {
  return count ? Json(*count) : Json();
}

void put(Json& object, const std::optional<Interval>& interval) {
  object["lower"] = interval ? Json(interval->lower) : Json();
  object["upper"] = interval ? Json(interval->upper) : Json();
}

void put(Json& object, const Estimate& estimate) {
  object["runs"] = estimate.runs;
  object["mean"] = to_json(estimate.mean);
  object["deviation"] = to_json(estimate.deviation);
  put(object, estimate.interval);
}

void put(Json& object, const MetricName& name) {
  object["metric"] = name.metric;
  object["species"] = name.species;
  object["group"] = name.group;
  object["unit"] = name.unit;
}

void put(Json& object, const Difference& difference) {
  object["value"] = to_json(difference.value);
  put(object, difference.interval);
  put_test(object, difference);
}

void put_test(Json& object, const Difference& difference) {
  object["p"] = to_json(difference.p);
  object["p_adjusted"] = to_json(difference.adjusted);
  object["differs"] = difference.adjusted ? Json(difference.differs()) : Json();
  object["runs_needed"] = to_json(difference.runs_needed());
}

void put_same(Json& object, const std::optional<MetricName>& same_as) {
  object["same_as"] = same_as ? Json(same_as->metric + ":" + same_as->species + ":" + same_as->group) : Json();
}

Json runs_json(const RunSet& set) {
  Json runs = Json::array();
  for (const RunManifest& manifest : set.manifests) {
    runs.push_back({{"folder", std::filesystem::absolute(manifest.folder).lexically_normal().string()},
                    {"seed", manifest.seed},
                    {"status", manifest.status},
                    {"builds", manifest.builds},
                    {"half_side_m", manifest.half_side_m},
                    {"until_s", manifest.until_s}});
  }
  return runs;
}

}  // namespace trophic::analysis::detail

namespace trophic::analysis {

Json claims_json(std::span<const ClaimConclusion> conclusions) {
  Json json = Json::array();
  for (const ClaimConclusion& each : conclusions) {
    Json claim;
    claim["claim"] = each.claim.title;
    claim["summary"] = summary_of(each);
    for (const ReadingConclusion& of : each.readings) {
      Json reading;
      detail::put(reading, metric_of(of.reading));
      reading["members"] = of.reading.members;
      reading["counting"] = of.reading.counting;
      reading["published"] = of.reading.value;
      reading["source"] = enum_name(of.reading.source);
      reading["margin"] = detail::to_json(margin_of(of.reading));
      reading["margin_from"] = of.reading.spread ? Json(enum_name(of.reading.spread->origin)) : Json();
      detail::put(reading, of.ours);
      reading["difference"] = detail::to_json(of.difference);
      reading["difference_lower"] = detail::to_json(lower_of(of.interval));
      reading["difference_upper"] = detail::to_json(upper_of(of.interval));
      reading["conclusion"] = enum_name(of.conclusion);
      reading["runs_needed"] = of.runs_needed ? Json(*of.runs_needed) : Json();
      claim["readings"].push_back(reading);
    }
    json.push_back(claim);
  }
  return json;
}

Json summary_json(const ShadowedSet& set, std::span<const SummaryRow> rows) {
  Json json;
  json["set"] = set.ours.label;
  json["backend"] = set.ours.manifests.front().backend;
  json["fingerprint"] = set.ours.manifests.front().fingerprint;
  json["min_runs_for_test"] = min_runs_for_test;
  json["runs"] = detail::runs_json(set.ours);
  json["shadow_runs"] = set.shadow ? detail::runs_json(*set.shadow) : Json::array();
  for (const SummaryRow& row : rows) {
    Json metric;
    detail::put(metric, row.name);
    detail::put(metric, row.ours);
    detail::put_same(metric, row.same_as);
    metric["published"] = detail::to_json(row.published);
    metric["baselines"] = Json::array();
    for (const Comparison& comparison : row.comparisons) {
      Json baseline;
      baseline["name"] = comparison.baseline;
      baseline["role"] = enum_name(comparison.role);
      baseline["value"] = detail::to_json(comparison.value);
      baseline["runs"] = comparison.runs;
      baseline["difference"] = detail::to_json(comparison.difference.value);
      detail::put(baseline, comparison.difference.interval);
      detail::put_test(baseline, comparison.difference);
      baseline["conclusion"] = comparison.role == Role::null ? Json(enum_name(comparison.test_result())) : Json();
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

Json differences_json(std::span<const SetDifference> differences) {
  Json json = Json::array();
  for (const SetDifference& d : differences) {
    Json entry;
    detail::put(entry, d.name);
    detail::put_same(entry, d.same_as);
    detail::put(entry["a"], d.a);
    detail::put(entry["b"], d.b);
    detail::put(entry["raw"], d.raw);
    detail::put(entry["over_shadow"], d.over_shadow);
    json.push_back(entry);
  }
  return json;
}

}  // namespace trophic::analysis
