// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <trophic/analysis/report/claim_verdict.hpp>
#include <trophic/support/rng.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::analysis;

namespace {

constexpr Claim tags{"tag_symmetry", "prey+predator", "inherited", 0.43, 0.065};

std::vector<double> spread(std::size_t count, double mean, double deviation) {
  std::vector<double> values;
  const double scale = deviation * std::sqrt(static_cast<double>(count - 1) / static_cast<double>(count));
  for (std::size_t i = 0; i < count; ++i) values.push_back(mean + (i % 2 == 0 ? scale : -scale));
  return values;
}

}  // namespace

TEST_CASE("within the margin is reproduced, even where the interval leaves the value out, and beyond it is not") {
  CHECK(judge(tags, spread(10, 0.43, 0.05)).verdict == Reproduction::reproduced);
  CHECK(judge(tags, spread(10, 0.46, 0.01)).verdict == Reproduction::reproduced);
  CHECK(judge(tags, spread(10, 0.55, 0.05)).verdict == Reproduction::not_reproduced);
  CHECK(judge(tags, spread(10, 0.49, 0.02)).verdict == Reproduction::not_reproduced);
}

TEST_CASE("an undecided claim says how many runs would decide, and they do") {
  const auto undecided = judge(tags, spread(10, 0.45, 0.15));
  CHECK(undecided.verdict == Reproduction::undecided);
  REQUIRE(undecided.runs_needed);
  CHECK(*undecided.runs_needed > 10);
  CHECK(judge(tags, spread(*undecided.runs_needed, 0.45, 0.15)).verdict == Reproduction::reproduced);
  CHECK(judge(tags, spread(*undecided.runs_needed - 2, 0.45, 0.15)).verdict == Reproduction::undecided);
  const auto far = judge(tags, spread(10, 0.55, 0.25));
  CHECK(far.verdict == Reproduction::undecided);
  CHECK(judge(tags, spread(*far.runs_needed + 1, 0.55, 0.25)).verdict == Reproduction::not_reproduced);
}

TEST_CASE("where a thousand runs would not decide no number is named") {
  CHECK_FALSE(runs_to_decide(tags, 0.43 + 0.065, 1.0));
  CHECK(*runs_to_decide(tags, 0.43, 1e-6) == runs_for_verdict);
  CHECK(*runs_to_decide(tags, 0.63, 1e-6) == runs_for_verdict);
}

TEST_CASE("a system that is the published one is called not reproduced in 5 % of cases at most") {
  Rng rng{4, Stream::user};
  for (const std::size_t runs : {std::size_t{10}, std::size_t{30}}) {
    int wrong = 0;
    constexpr int trials = 4000;
    for (int trial = 0; trial < trials; ++trial) {
      Claim claim = tags;
      claim.value = rng.normal(0.43, tags.margin / std::sqrt(static_cast<double>(published_runs)));
      std::vector<double> values(runs);
      for (double& value : values) value = rng.normal(0.43, tags.margin);
      if (judge(claim, values).verdict == Reproduction::not_reproduced) ++wrong;
    }
    CAPTURE(runs);
    CHECK(wrong > 0);
    CHECK(wrong < 0.06 * trials);
  }
}

TEST_CASE("five runs get numbers and no verdict") {
  const auto few = judge(tags, spread(5, 0.43, 0.01));
  CHECK(few.verdict == Reproduction::unknown);
  CHECK(few.ours.runs == 5);
  CHECK(few.ours.deviation);
  CHECK_FALSE(few.ours.interval);
  CHECK_FALSE(few.runs_needed);
}

TEST_CASE("runs that are off by the whole margin are called reproduced in 5 % of cases") {
  Rng rng{3, Stream::user};
  int wrong = 0;
  constexpr int trials = 4000;
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<double> values(8);
    for (double& value : values) value = rng.normal(0.43 + 0.065, 0.02);
    if (judge(tags, values).verdict == Reproduction::reproduced) ++wrong;
  }
  CHECK(wrong > 0.035 * trials);
  CHECK(wrong < 0.065 * trials);
}

TEST_CASE("every claim is judged for runs that measured it") {
  std::vector<RunMetrics> runs(6);
  for (RunMetrics& run : runs) run.measurements = {{metric_of(tags), 0.43, {}}};
  const auto verdicts = judge_claims(runs);
  REQUIRE(verdicts.size() == 1);
  CHECK(verdicts[0].verdict == Reproduction::reproduced);
}
