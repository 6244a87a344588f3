// SPDX-License-Identifier: MIT
// Definitions of claim_conclusion.hpp.
#include <tools/analysis/report/claim_conclusion.hpp>

#include <algorithm>
#include <cmath>
#include <trophic/params/params.hpp>

namespace trophic::analysis {

Contrast less_published(const Contrast& ours, const ClaimReading& reading) {
  if (!reading.spread) return {ours.value - reading.value, ours.error, ours.freedom};
  const double theirs = reading.spread->deviation * reading.spread->deviation / static_cast<double>(published_runs);
  const double own = ours.error * ours.error;
  const double squares = theirs * theirs / static_cast<double>(published_runs - 1) + own * own / ours.freedom;
  return {ours.value - reading.value, std::sqrt(own + theirs), (own + theirs) * (own + theirs) / squares};
}

Reproduction conclusion_on(const Contrast& difference, const std::optional<double>& margin) {
  if (!margin) return Reproduction::none;
  switch (test_equivalence(difference, *margin).conclusion) {
    case Equivalence::equivalent:
      return Reproduction::reproduced;
    case Equivalence::different:
      return Reproduction::not_reproduced;
    case Equivalence::inconclusive:
      return Reproduction::inconclusive;
    case Equivalence::unknown:
      break;
  }
  return Reproduction::none;
}

std::optional<std::size_t> runs_to_decide(const ClaimReading& reading, double mean, double deviation) {
  const auto decides = [&](std::size_t runs) {
    const auto count = static_cast<double>(runs);
    const Contrast ours{mean, deviation / std::sqrt(count), count - 1.0};
    const Reproduction conclusion = conclusion_on(less_published(ours, reading), margin_of(reading));
    return conclusion == Reproduction::reproduced || conclusion == Reproduction::not_reproduced;
  };
  for (std::size_t runs = min_runs_for_test; runs <= 1000; ++runs) {
    if (decides(runs)) return runs;
  }
  return std::nullopt;
}

ReadingConclusion judge(const ClaimReading& reading, std::span<const double> values) {
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

std::vector<ClaimConclusion> judge_claims(std::span<const RunMetrics> runs) {
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

namespace {

/// The condition that the readings of this conclusion share and no other reading has: "the inactive are left out". If there is no
/// such, the conditions of each of them.
std::string condition_for(std::span<const ReadingConclusion> readings, Reproduction conclusion) {
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

}  // namespace

std::string summary_of(const ClaimConclusion& claim) {
  const auto count = [&](Reproduction of) { return std::ranges::count(claim.readings, of, &ReadingConclusion::conclusion); };
  const auto all = static_cast<std::ptrdiff_t>(claim.readings.size());
  if (all == 1) return std::string{enum_name(claim.readings.front().conclusion)};
  if (count(Reproduction::none) == all) return "no conclusion under any reading";
  if (count(Reproduction::reproduced) == all) return "reproduced under every reading";
  if (count(Reproduction::not_reproduced) == all) return "not reproduced under any reading";
  if (count(Reproduction::inconclusive) == all) return "inconclusive under every reading";
  if (count(Reproduction::reproduced) > 0) return "reproduced if " + condition_for(claim.readings, Reproduction::reproduced);
  if (count(Reproduction::inconclusive) > 0) {
    return "reproduced under no reading, inconclusive if " + condition_for(claim.readings, Reproduction::inconclusive);
  }
  return "reproduced under no reading";
}

}  // namespace trophic::analysis
