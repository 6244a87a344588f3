// SPDX-License-Identifier: MIT
// Results for machines: summary.json.
#pragma once

#include <tools/analysis/metrics/run_set.hpp>
#include <tools/analysis/report/claim_conclusion.hpp>
#include <tools/analysis/report/compare_sets.hpp>
#include <tools/analysis/report/summary.hpp>
#include <trophic/support/json.hpp>

namespace trophic::analysis {

namespace detail {

[[nodiscard]] Json to_json(const std::optional<double>& value);
[[nodiscard]] Json to_json(const std::optional<std::size_t>& count);

void put(Json& object, const std::optional<Interval>& interval);

void put(Json& object, const Estimate& estimate);

void put(Json& object, const MetricName& name);

void put(Json& object, const Difference& difference);

void put_test(Json& object, const Difference& difference);

/// Adds the metric that has the same values in every run, as METRIC:SPECIES:GROUP, or null.
void put_same(Json& object, const std::optional<MetricName>& same_as);

[[nodiscard]] Json runs_json(const RunSet& set);

}  // namespace detail

/// Conclusions on published claims as JSON: one object a claim, with one flat object for each of its readings.
[[nodiscard]] Json claims_json(std::span<const ClaimConclusion> conclusions);

/// A set as JSON: its runs, for each metric the mean with spread and 95 % interval, the paper's value and every baseline, and the
/// conclusions on every published claim. null is what could not be computed. Baselines that are not nulls have no test result.
[[nodiscard]] Json summary_json(const ShadowedSet& set, std::span<const SummaryRow> rows);

/// Differences of two sets as JSON.
[[nodiscard]] Json differences_json(std::span<const SetDifference> differences);

}  // namespace trophic::analysis
