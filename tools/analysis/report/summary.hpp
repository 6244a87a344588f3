// SPDX-License-Identifier: MIT
// Many runs as one result: means, intervals, and what they say against each null.
#pragma once

#include <cstddef>
#include <tools/analysis/metrics/measurement.hpp>
#include <tools/analysis/report/published.hpp>
#include <tools/analysis/statistics/difference.hpp>
#include <tools/analysis/statistics/estimate.hpp>
#include <tools/analysis/statistics/interval.hpp>

namespace trophic::analysis {

/// Our value next to a baseline. Only a null has a difference and a test result.
struct Comparison {
  std::string baseline;
  Role role = Role::reference;
  std::optional<double> value;  ///< the baseline's mean over the runs
  std::size_t runs = 0;         ///< of the baseline
  Difference difference = {};   ///< ours - null; corrected for all metrics of the summary
  [[nodiscard]] TestResult test_result() const { return analysis::test_result(difference.interval); }
};

struct SummaryRow {
  MetricName name;
  Estimate ours;
  std::optional<double> published;
  std::vector<Comparison> comparisons;     ///< the shadow first, if there is one
  std::optional<MetricName> same_as = {};  ///< see repeated_metrics; not compared again
};

/// The name of the comparison with the neutral shadow.
inline constexpr std::string_view shadow_name = "shadow";

namespace detail {

/// As two independent sets. Runs and shadows of one seed are slightly alike (kinematic, 60 seeds, 41 metrics: correlation 0.13 in
/// the median, 0.47 at most), so that intervals are rather too wide. Pairing would gain that, and at ten runs lose as much in
/// degrees of freedom.
[[nodiscard]] Comparison against_shadow(std::span<const double> ours, std::span<const double> shadow);

/// A baseline that each run has of its own: paired by run.
[[nodiscard]] Comparison against_own(std::span<const RunMetrics> runs, std::size_t measurement, std::size_t baseline);

}  // namespace detail

/// Pools runs that measured the same things in the same order (those of one food web) and compares them with the runs of their
/// shadow. Runs that lack a value are left out of that value's mean. `choices`: see `chosen`. p values are corrected for all rows
/// that repeat no earlier one. Throws std::invalid_argument if the runs measured different things, or if a choice names no
/// metric.
[[nodiscard]] std::vector<SummaryRow> summarize(std::span<const RunMetrics> runs, std::span<const RunMetrics> shadow = {},
                                                std::span<const std::string> choices = {});

}  // namespace trophic::analysis
