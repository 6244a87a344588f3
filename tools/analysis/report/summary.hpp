// SPDX-License-Identifier: MIT
// Many runs as one result: means, intervals, and what they say against each null.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tools/analysis/metrics/measurement.hpp>
#include <tools/analysis/report/published.hpp>
#include <tools/analysis/statistics/estimate.hpp>
#include <tools/analysis/statistics/interval.hpp>
#include <vector>

namespace trophic::analysis {

/// Ours beside another value. Only a null has a difference, and a verdict.
struct Comparison {
  std::string baseline;
  Role role = Role::reference;
  std::optional<double> value;       ///< the baseline's mean over the runs
  std::optional<double> difference;  ///< ours - null
  std::optional<Interval> interval;  ///< of the difference
  [[nodiscard]] TestResult test_result() const { return analysis::test_result(interval); }
};

struct SummaryRow {
  MetricName name;
  Estimate ours;
  std::optional<double> published;
  std::vector<Comparison> comparisons;  ///< the shadow first, where there is one
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

/// Pools runs that measured the same things in the same order (those of one food web), and sets them beside the runs of their
/// shadow. Runs that lack a value are left out of that value's mean. Throws std::invalid_argument if the runs measured different
/// things.
[[nodiscard]] std::vector<SummaryRow> summarize(std::span<const RunMetrics> runs, std::span<const RunMetrics> shadow = {});

}  // namespace trophic::analysis
