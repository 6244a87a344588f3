// SPDX-License-Identifier: MIT
// Is a published claim reproduced? Equivalence within its margin, exclusion, or neither yet.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <trophic/analysis/metrics/measurement.hpp>
#include <trophic/analysis/report/published.hpp>
#include <trophic/analysis/statistics/equivalence.hpp>
#include <trophic/analysis/statistics/estimate.hpp>
#include <trophic/analysis/statistics/interval.hpp>
#include <vector>

namespace trophic::analysis {

/// `reproduced`: two one-sided tests at 5 % place our mean within the margin of the published value. `not_reproduced`: they do
/// not, and the 95 % interval of our mean less the published one leaves out zero (less_published). `undecided`: neither.
/// `unknown`: too few runs for any of them.
enum class Reproduction { unknown, reproduced, not_reproduced, undecided };
[[nodiscard]] constexpr std::array<std::string_view, 4> enum_names(Reproduction) {
  return {"no verdict", "reproduced", "not reproduced", "undecided"};
}

/// A claim beside ours.
struct ClaimVerdict {
  Claim claim;
  Estimate ours;
  Reproduction verdict = Reproduction::unknown;
  std::optional<std::size_t> runs_needed;  ///< of an undecided one
};

/// Ours less a published mean, which is itself one of ten runs that spread by the claim's margin: two systems that are the same
/// must not differ by that alone.
[[nodiscard]] inline Contrast less_published(const Contrast& ours, const Claim& claim) {
  const double theirs = claim.margin * claim.margin / static_cast<double>(published_runs);
  const double own = ours.error * ours.error;
  const double squares = theirs * theirs / static_cast<double>(published_runs - 1) + own * own / ours.freedom;
  return {ours.value - claim.value, std::sqrt(own + theirs), (own + theirs) * (own + theirs) / squares};
}

/// Whether the interval of a contrast leaves out zero.
[[nodiscard]] inline bool is_apart(const Contrast& off) {
  const Interval interval = *interval_of(off);
  return interval.lower > 0.0 || interval.upper < 0.0;
}

/// Runs that would decide a claim, if our mean and spread stay as they are. None if a thousand would not.
[[nodiscard]] inline std::optional<std::size_t> runs_to_decide(const Claim& claim, double mean, double deviation) {
  for (std::size_t runs = runs_for_verdict; runs <= 1000; ++runs) {
    const auto count = static_cast<double>(runs);
    const Contrast ours{mean, deviation / std::sqrt(count), count - 1.0};
    Contrast off = ours;
    off.value -= claim.value;
    if (test_equivalence(off, claim.margin).verdict == Equivalence::equivalent) return runs;
    if (is_apart(less_published(ours, claim))) return runs;
  }
  return std::nullopt;
}

[[nodiscard]] inline ClaimVerdict judge(const Claim& claim, std::span<const double> values) {
  ClaimVerdict result{claim, estimate(values), Reproduction::unknown, {}};
  const auto ours = contrast({{1.0, values}});
  if (!ours) return result;
  Contrast off = *ours;
  off.value -= claim.value;
  if (test_equivalence(off, claim.margin).verdict == Equivalence::equivalent) {
    result.verdict = Reproduction::reproduced;
  } else if (is_apart(less_published(*ours, claim))) {
    result.verdict = Reproduction::not_reproduced;
  } else {
    result.verdict = Reproduction::undecided;
    result.runs_needed = runs_to_decide(claim, ours->value, *result.ours.deviation);
  }
  return result;
}

/// Every claim about a metric that the runs have.
[[nodiscard]] inline std::vector<ClaimVerdict> judge_claims(std::span<const RunMetrics> runs) {
  std::vector<ClaimVerdict> verdicts;
  for (const Claim& claim : claims) {
    const auto& first = runs.front().measurements;
    if (std::ranges::find(first, metric_of(claim), &Measurement::name) == first.end()) continue;
    verdicts.push_back(judge(claim, values_of(runs, metric_of(claim))));
  }
  return verdicts;
}

}  // namespace trophic::analysis
