// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <array>
#include <optional>
#include <stdexcept>
#include <tools/analysis/report/summary.hpp>
#include <unit/reading/rows.hpp>
#include <vector>

namespace {

using namespace trophic;
using namespace trophic::analysis;

RunMetrics run_with(std::optional<double> value, std::optional<double> null) {
  return {.measurements = {{.name = {"tag_symmetry", "prey+predator", "inherited", "1"},
                            .value = value,
                            .baselines = {{"permuted_tags", Role::null, null}, {"uniform_pairs", Role::paper, 2.0 / 3.0}}}},
          .curves = {}};
}

std::vector<RunMetrics> runs_around(double value, double null, std::size_t count = 6) {
  std::vector<RunMetrics> runs;
  for (std::size_t i = 0; i < count; ++i) {
    const double shift = i % 2 == 0 ? 0.01 : -0.01;
    runs.push_back(run_with(value + shift, null + 2.0 * shift));
  }
  return runs;
}

}  // namespace

TEST_CASE("only nulls get a difference and a conclusion, and the paper's baseline is shown") {
  const auto rows = summarize(runs_around(0.50, 0.40));
  REQUIRE(rows.size() == 1);
  CHECK(*rows[0].ours.mean == doctest::Approx(0.50));
  CHECK(*rows[0].published == 0.43);
  REQUIRE(rows[0].comparisons.size() == 2);
  CHECK(rows[0].comparisons[0].baseline == "permuted_tags");
  CHECK(rows[0].comparisons[0].test_result() == TestResult::above);
  CHECK(*rows[0].comparisons[1].value == doctest::Approx(2.0 / 3.0));
  CHECK_FALSE(rows[0].comparisons[1].difference.value);
  CHECK(rows[0].comparisons[1].test_result() == TestResult::unknown);
}

TEST_CASE("a run's own null is paired with it: a shift that every run has is seen through their spread") {
  std::vector<RunMetrics> runs;
  for (const double level : {0.2, 0.9, 0.5, 0.7, 0.3, 0.6}) runs.push_back(run_with(level + 0.01, level));
  const auto row = summarize(runs).front();
  CHECK(row.comparisons[0].test_result() == TestResult::above);
  CHECK(row.comparisons[0].difference.interval->lower == doctest::Approx(0.01));
}

TEST_CASE("the shadow comes first, its runs are a set of their own") {
  const auto ours = runs_around(0.50, 0.50, 8);
  const auto shadow = runs_around(0.40, 0.40, 6);
  const auto row = summarize(ours, shadow).front();
  REQUIRE(row.comparisons.size() == 3);
  const Comparison& against = row.comparisons[0];
  CHECK(against.baseline == "shadow");
  CHECK(against.role == Role::null);
  CHECK(*against.value == doctest::Approx(0.40));
  CHECK(*against.difference.value == doctest::Approx(0.10));
  CHECK(against.test_result() == TestResult::above);
  CHECK(summarize(shadow, ours).front().comparisons[0].test_result() == TestResult::below);
  CHECK(summarize(ours, ours).front().comparisons[0].test_result() == TestResult::not_significant);
}

TEST_CASE("five runs, or five of the shadow, have numbers and no conclusion") {
  const auto few = runs_around(0.5, 0.1, 5);
  const auto row = summarize(few, few).front();
  CHECK(row.ours.runs == 5);
  CHECK(row.ours.mean);
  CHECK(row.ours.deviation);
  CHECK_FALSE(row.ours.interval);
  for (const Comparison& comparison : row.comparisons) CHECK(comparison.test_result() == TestResult::unknown);
  CHECK(row.comparisons[0].difference.value);
  CHECK(summarize(runs_around(0.5, 0.1), few).front().comparisons[0].test_result() == TestResult::unknown);
}

TEST_CASE("runs without a value are left out") {
  const std::array runs{run_with(0.6, 0.5), run_with({}, {}), run_with(0.8, {})};
  const auto row = summarize(runs).front();
  CHECK(row.ours.runs == 2);
  CHECK(*row.ours.mean == doctest::Approx(0.7));
  CHECK(*row.comparisons[0].difference.value == doctest::Approx(0.1));
  const std::array none{run_with({}, {})};
  CHECK_FALSE(summarize(none).front().ours.mean);
  CHECK_FALSE(summarize(none).front().ours.deviation);
  CHECK(summarize({}).empty());
}

TEST_CASE("summary: runs of different food webs -> not pooled, nor compared with another web's shadow") {
  auto runs = runs_around(0.5, 0.5);
  const auto shadow = runs;
  runs[1].measurements[0].name.species = "wolf";
  CHECK_THROWS_AS(static_cast<void>(summarize(runs)), std::invalid_argument);
  CHECK_THROWS_AS(static_cast<void>(summarize(shadow, runs)), std::invalid_argument);
}
