// SPDX-License-Identifier: MIT
// Is a published claim reproduced? Under each of its readings: equivalence within a margin, a difference, or neither yet.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tools/analysis/metrics/measurement.hpp>
#include <tools/analysis/report/published.hpp>
#include <tools/analysis/statistics/equivalence.hpp>
#include <tools/analysis/statistics/estimate.hpp>
#include <tools/analysis/statistics/interval.hpp>
#include <trophic/params/params.hpp>
#include <utility>
#include <vector>

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
[[nodiscard]] inline Contrast less_published(const Contrast& ours, const ClaimReading& reading) {
  if (!reading.spread) return {ours.value - reading.value, ours.error, ours.freedom};
  const double theirs = reading.spread->deviation * reading.spread->deviation / static_cast<double>(published_runs);
  const double own = ours.error * ours.error;
  const double squares = theirs * theirs / static_cast<double>(published_runs - 1) + own * own / ours.freedom;
  return {ours.value - reading.value, std::sqrt(own + theirs), (own + theirs) * (own + theirs) / squares};
}

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
[[nodiscard]] inline Reproduction conclusion_on(const Contrast& difference, const std::optional<double>& margin) {
  if (!margin) return Reproduction::none;
  switch (test_equivalence(difference, *margin).verdict) {
    case Equivalence::equivalent:
      return Reproduction::reproduced;
    case Equivalence::different:
      return Reproduction::not_reproduced;
    case Equivalence::undecided:
      return Reproduction::inconclusive;
    case Equivalence::unknown:
      break;
  }
  return Reproduction::none;
}

/// Runs that would decide if our mean and spread stay as they are. None if a thousand would not: the published mean's error
/// stays.
[[nodiscard]] inline std::optional<std::size_t> runs_to_decide(const ClaimReading& reading, double mean, double deviation) {
  const auto decides = [&](std::size_t runs) {
    const auto count = static_cast<double>(runs);
    const Contrast ours{mean, deviation / std::sqrt(count), count - 1.0};
    const Reproduction conclusion = conclusion_on(less_published(ours, reading), margin_of(reading));
    return conclusion == Reproduction::reproduced || conclusion == Reproduction::not_reproduced;
  };
  for (std::size_t runs = runs_for_verdict; runs <= 1000; ++runs) {
    if (decides(runs)) return runs;
  }
  return std::nullopt;
}

/// Compares values, one a run, with a reading of a claim.
[[nodiscard]] inline ReadingConclusion judge(const ClaimReading& reading, std::span<const double> values) {
  ReadingConclusion result{reading, estimate(values), {}, {}, Reproduction::none, {}};
  if (result.ours.mean) result.difference = *result.ours.mean - reading.value;
  const auto ours = contrast({{1.0, values}});
  if (!ours) return result;
  const Contrast difference = less_published(*ours, reading);
  result.interval = interval_of(difference);
  result.conclusion = conclusion_on(difference, margin_of(reading));
  if (result.conclusion == Reproduction::inconclusive) {
    result.runs_needed = runs_to_decide(reading, ours->value, *result.ours.deviation);
  }
  return result;
}

/// Every claim about metrics that the runs have, under each of its readings.
[[nodiscard]] inline std::vector<ClaimConclusion> judge_claims(std::span<const RunMetrics> runs) {
  std::vector<ClaimConclusion> conclusions;
  for (const Claim& claim : claims) {
    ClaimConclusion result{claim, {}};
    for (const ClaimReading& reading : claim.readings) {
      const auto& first = runs.front().measurements;
      if (std::ranges::find(first, metric_of(reading), &Measurement::name) == first.end()) continue;
      result.readings.push_back(judge(reading, values_of(runs, metric_of(reading))));
    }
    if (!result.readings.empty()) conclusions.push_back(std::move(result));
  }
  return conclusions;
}

namespace detail {

/// The condition that the readings of this conclusion share and no other reading has: "the inactive are left out". If there is no
/// such, the conditions of each of them.
[[nodiscard]] inline std::string condition_for(std::span<const ReadingConclusion> readings, Reproduction conclusion) {
  using Part = std::string_view ClaimReading::*;
  for (const Part part : {&ClaimReading::members, &ClaimReading::counting}) {
    const auto chosen = std::ranges::find(readings, conclusion, &ReadingConclusion::conclusion);
    const std::string_view condition = chosen->reading.*part;
    const auto fits = [&](const ReadingConclusion& each) {
      return (each.conclusion == conclusion) == (each.reading.*part == condition);
    };
    if (!condition.empty() && std::ranges::all_of(readings, fits)) return std::string{condition};
  }
  std::string all;
  for (const ReadingConclusion& each : readings) {
    if (each.conclusion != conclusion) continue;
    const std::string_view members = each.reading.members;
    const std::string_view counting = each.reading.counting;
    all += (all.empty() ? "" : ", or ") + std::string{members};
    all += (members.empty() || counting.empty() ? "" : " and ") + std::string{counting};
  }
  return all;
}

}  // namespace detail

/// A claim's readings in half a sentence: "reproduced if the inactive are left out", "not reproduced under any reading".
[[nodiscard]] inline std::string summary_of(const ClaimConclusion& claim) {
  const auto count = [&](Reproduction of) { return std::ranges::count(claim.readings, of, &ReadingConclusion::conclusion); };
  const auto all = static_cast<std::ptrdiff_t>(claim.readings.size());
  if (all == 1) return std::string{enum_name(claim.readings.front().conclusion)};
  if (count(Reproduction::none) == all) return "no conclusion under any reading";
  if (count(Reproduction::reproduced) == all) return "reproduced under every reading";
  if (count(Reproduction::not_reproduced) == all) return "not reproduced under any reading";
  if (count(Reproduction::inconclusive) == all) return "inconclusive under every reading";
  if (count(Reproduction::reproduced) > 0)
    return "reproduced if " + detail::condition_for(claim.readings, Reproduction::reproduced);
  if (count(Reproduction::inconclusive) > 0) {
    return "reproduced under no reading, inconclusive if " + detail::condition_for(claim.readings, Reproduction::inconclusive);
  }
  return "reproduced under no reading";
}

}  // namespace trophic::analysis
