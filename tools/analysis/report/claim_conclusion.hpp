// SPDX-License-Identifier: MIT
// Is a published claim reproduced? Under each of its readings: equivalence within a margin, a difference, or neither yet.
#pragma once

#include <cstddef>
#include <tools/analysis/metrics/measurement.hpp>
#include <tools/analysis/report/published.hpp>
#include <tools/analysis/statistics/equivalence.hpp>
#include <tools/analysis/statistics/estimate.hpp>
#include <tools/analysis/statistics/interval.hpp>

namespace trophic::analysis {

/// `reproduced`: two one-sided tests at 5 % place our system within the margin of the published one. `not_reproduced`: they do
/// not, and the 95 % interval of ours less the published one leaves out zero. `inconclusive`: neither. `none`: too few runs, or
/// no margin is known.
enum class Reproduction { none, reproduced, not_reproduced, inconclusive };
[[nodiscard]] constexpr std::array<std::string_view, 4> enum_names(Reproduction) {
  return {"no conclusion", "reproduced", "not reproduced", "inconclusive"};
}

/// Ours compared with the published number under one reading.
struct ReadingConclusion {
  ClaimReading reading;
  Estimate ours;
  std::optional<double> difference;  ///< ours - published
  std::optional<Interval> interval;  ///< of it, 95 %; the published mean's own error is in it if a spread is known
  Reproduction conclusion = Reproduction::none;
  std::optional<std::size_t> runs_needed;  ///< of an inconclusive one; none if no number of runs would decide
};

/// A claim under all of its readings that the runs measured.
struct ClaimConclusion {
  Claim claim;
  std::vector<ReadingConclusion> readings;
};

/// Two systems whose means differ by less than this show the same: one standard deviation between runs, so that single runs of
/// them are hard to distinguish. None if no such deviation is known.
[[nodiscard]] constexpr std::optional<double> margin_of(const ClaimReading& reading) {
  return reading.spread ? std::optional{reading.spread->deviation} : std::nullopt;
}

/// Our mean less the published one. The published mean is itself one of ten runs, so its error is part of the difference's
/// [welch1947]; without a spread that error is unknown and left out.
[[nodiscard]] Contrast less_published(const Contrast& ours, const ClaimReading& reading);

/// The conclusion on a difference from less_published.
///
/// Both tests are about the published system, whose true mean the published one only estimates. Taking that estimate for the
/// truth would call the published system itself "not reproduced" in 11 % of cases, and one that is a margin away "reproduced" in
/// 10 %. With the estimate's error both stay below 5 % (tests/unit/analysis/calibration_test.cpp), at the price of power.
/// Simulated, of runs of ours with the spread of the published ones (20,000 sets; 3000 of 1000 runs):
///
///   our runs                                         6      10     20     30     100    1000
///   the published system: "reproduced"               19 %   38 %   60 %   68 %   78 %   82 %
///   two margins away: "not reproduced"               93 %   99 %   100 %  100 %  100 %  100 %
///
/// All other cases of these are "inconclusive", but for the errors. Only more published runs would take "reproduced" beyond 82 %.
[[nodiscard]] Reproduction conclusion_on(const Contrast& difference, const std::optional<double>& margin);

/// Runs that would decide if our mean and spread stay as they are. None if a thousand would not: the published mean's error
/// stays.
[[nodiscard]] std::optional<std::size_t> runs_to_decide(const ClaimReading& reading, double mean, double deviation);

/// Compares values, one a run, with a reading of a claim.
[[nodiscard]] ReadingConclusion judge(const ClaimReading& reading, std::span<const double> values);

/// Every claim about metrics that the runs have, under each of its readings.
[[nodiscard]] std::vector<ClaimConclusion> judge_claims(std::span<const RunMetrics> runs);

/// A claim's readings in half a sentence: "reproduced if the inactive are left out", "not reproduced under any reading".
[[nodiscard]] std::string summary_of(const ClaimConclusion& claim);

}  // namespace trophic::analysis
