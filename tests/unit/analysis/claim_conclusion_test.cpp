// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <tools/analysis/report/claim_conclusion.hpp>
#include <trophic/params/params.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::analysis;

namespace {

constexpr ClaimReading tags{
    "tag_symmetry", "prey+predator", "inherited", "", "", 0.43, Spread{0.065, SpreadOrigin::published_range}};

std::vector<double> spread_out(std::size_t count, double mean, double deviation) {
  std::vector<double> values;
  const double scale = deviation * std::sqrt(static_cast<double>(count - 1) / static_cast<double>(count));
  for (std::size_t i = 0; i < count; ++i) values.push_back(mean + (i % 2 == 0 ? scale : -scale));
  return values;
}

/// A claim whose readings, all with conditions, have these conclusions.
ClaimConclusion concluded(const std::vector<std::pair<ClaimReading, Reproduction>>& readings) {
  ClaimConclusion claim{};
  for (const auto& [reading, conclusion] : readings) claim.readings.push_back({reading, {}, {}, {}, conclusion, {}});
  return claim;
}

}  // namespace

TEST_CASE("judge: mean and spread of ten runs -> conclusion") {
  struct Case {
    double mean;
    double deviation;
    Reproduction conclusion;
  };
  for (const Case& of : {Case{0.43, 0.05, Reproduction::reproduced}, Case{0.44, 0.01, Reproduction::reproduced},
                         Case{0.46, 0.01, Reproduction::inconclusive}, Case{0.55, 0.05, Reproduction::not_reproduced},
                         Case{0.50, 0.02, Reproduction::not_reproduced}, Case{0.45, 0.15, Reproduction::inconclusive}}) {
    CAPTURE(of.mean);
    CAPTURE(of.deviation);
    const auto judged = judge(tags, spread_out(10, of.mean, of.deviation));
    CHECK(enum_name(judged.conclusion) == enum_name(of.conclusion));
    CHECK(*judged.difference == doctest::Approx(of.mean - 0.43));
    CHECK(judged.interval->lower < of.mean - 0.43);
  }
}

TEST_CASE("judge: no spread known -> difference with its interval, no conclusion") {
  ClaimReading unknown = tags;
  unknown.spread.reset();
  const auto values = spread_out(10, 0.55, 0.05);
  const auto judged = judge(unknown, values);
  CHECK(judged.conclusion == Reproduction::none);
  CHECK_FALSE(margin_of(unknown));
  CHECK(*judged.difference == doctest::Approx(0.12));
  CHECK(judged.interval->lower == doctest::Approx(interval_of_mean(values)->lower - 0.43));
}

TEST_CASE("judge: five runs -> numbers, no conclusion") {
  const auto few = judge(tags, spread_out(5, 0.43, 0.01));
  CHECK(few.conclusion == Reproduction::none);
  CHECK(few.ours.runs == 5);
  CHECK(few.ours.deviation);
  CHECK(few.difference);
  CHECK_FALSE(few.interval);
  CHECK_FALSE(few.runs_needed);
  CHECK_FALSE(judge(tags, {}).difference);
}

TEST_CASE("judge: inconclusive -> the number of runs that would decide, and they do") {
  const auto near = judge(tags, spread_out(10, 0.435, 0.15));
  REQUIRE(near.runs_needed);
  const std::size_t enough = *near.runs_needed + *near.runs_needed % 2;  // an even number has this mean and spread exactly
  CHECK(enough > 10);
  CHECK(judge(tags, spread_out(enough, 0.435, 0.15)).conclusion == Reproduction::reproduced);
  CHECK(judge(tags, spread_out(enough - 2, 0.435, 0.15)).conclusion == Reproduction::inconclusive);
  const auto far = judge(tags, spread_out(10, 0.55, 0.25));
  CHECK(judge(tags, spread_out(*far.runs_needed + *far.runs_needed % 2, 0.55, 0.25)).conclusion == Reproduction::not_reproduced);
}

TEST_CASE("runs_to_decide: the published mean's own error leaves it open -> none") {
  CHECK_FALSE(runs_to_decide(tags, 0.43 + 0.6 * 0.065, 1e-6));
  CHECK(*runs_to_decide(tags, 0.43, 1e-6) == min_runs_for_test);
  CHECK(*runs_to_decide(tags, 0.63, 1e-6) == min_runs_for_test);
}

TEST_CASE("judge_claims: runs that measured one reading of a claim -> that claim with that reading") {
  std::vector<RunMetrics> runs(6);
  for (RunMetrics& run : runs) run.measurements = {{metric_of(tags), 0.43, {}}};
  const auto conclusions = judge_claims(runs);
  REQUIRE(conclusions.size() == 1);
  CHECK(conclusions[0].claim.title == "tag symmetry");
  REQUIRE(conclusions[0].readings.size() == 1);
  CHECK(conclusions[0].readings[0].conclusion == Reproduction::reproduced);
}

TEST_CASE("summary_of: conclusions of the readings -> half a sentence") {
  const auto reading = [](std::string_view members, std::string_view counting) {
    ClaimReading made = tags;
    made.members = members;
    made.counting = counting;
    return made;
  };
  const auto all_a = reading("all count", "by a");
  const auto all_b = reading("all count", "by b");
  const auto few_a = reading("few count", "by a");
  const auto few_b = reading("few count", "by b");
  constexpr auto yes = Reproduction::reproduced;
  constexpr auto no = Reproduction::not_reproduced;
  constexpr auto open = Reproduction::inconclusive;
  constexpr auto none = Reproduction::none;
  struct Case {
    std::vector<std::pair<ClaimReading, Reproduction>> readings;
    std::string summary;
  };
  const std::vector<Case> cases{
      {{{tags, open}}, "inconclusive"},
      {{{all_a, yes}, {few_a, yes}}, "reproduced under every reading"},
      {{{all_a, no}, {few_a, no}}, "not reproduced under any reading"},
      {{{all_a, open}, {few_a, open}}, "inconclusive under every reading"},
      {{{all_a, none}, {few_a, none}}, "no conclusion under any reading"},
      {{{all_a, no}, {all_b, no}, {few_a, yes}, {few_b, yes}}, "reproduced if few count"},
      {{{all_a, yes}, {all_b, open}, {few_a, yes}, {few_b, no}}, "reproduced if by a"},
      {{{all_a, yes}, {all_b, no}, {few_a, no}, {few_b, yes}}, "reproduced if all count and by a, or few count and by b"},
      {{{all_a, no}, {few_a, open}}, "reproduced under no reading, inconclusive if few count"},
      {{{all_a, no}, {few_a, none}}, "reproduced under no reading"},
  };
  for (const auto& [readings, summary] : cases) CHECK(summary_of(concluded(readings)) == summary);
}
