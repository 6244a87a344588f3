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
/// not, and our 95 % interval leaves the published value out. `undecided`: neither. `unknown`: too few runs for any of them.
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

[[nodiscard]] inline ClaimVerdict judge(const Claim& claim, std::span<const double> values) {
  ClaimVerdict result{claim, estimate(values), Reproduction::unknown, {}};
  auto off = contrast({{1.0, values}});
  if (!off) return result;
  off->value -= claim.value;
  switch (test_equivalence(off, claim.margin).verdict) {
    case Equivalence::equivalent:
      result.verdict = Reproduction::reproduced;
      break;
    case Equivalence::different:
      result.verdict = Reproduction::not_reproduced;
      break;
    case Equivalence::undecided:
    case Equivalence::unknown:
      result.verdict = Reproduction::undecided;
      result.runs_needed = runs_to_decide(std::abs(off->value), *result.ours.deviation, claim.margin);
      break;
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
