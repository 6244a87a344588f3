// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <trophic/measure/summary.hpp>
#include <unit/measure/rows.hpp>
#include <vector>

namespace {

using namespace trophic;
using namespace trophic::measure;

RunMetrics run_with(std::optional<double> value, std::optional<double> null) {
  return {.measurements = {{.name = {"attribution_catches", "predator", "all", "1"},
                            .value = value,
                            .baselines = {{"two_thirds", true, 2.0 / 3.0}, {"share_alive", false, null}}}},
          .curves = {}};
}

}  // namespace

TEST_CASE("a conclusion that the right null turns around is found") {
  const std::array runs{run_with(0.72, 0.71), run_with(0.74, 0.75), run_with(0.73, 0.73), run_with(0.71, 0.71)};
  const auto rows = summarize(runs);
  REQUIRE(rows.size() == 1);
  CHECK(*rows[0].ours.mean == doctest::Approx(0.725));
  CHECK(*rows[0].published == 0.725);
  CHECK(rows[0].comparisons[0].verdict() == Verdict::above);
  CHECK(rows[0].comparisons[1].verdict() == Verdict::not_distinguishable);
  REQUIRE(rows[0].contradictions().size() == 1);
  CHECK(rows[0].contradictions()[0]->baseline == "share_alive");
}

TEST_CASE("differences are paired by run: a shift that every run has is seen through their spread") {
  const std::array runs{run_with(0.5, 0.49), run_with(0.9, 0.89), run_with(0.7, 0.69)};
  const auto row = summarize(runs).front();
  CHECK(row.comparisons[0].verdict() == Verdict::not_distinguishable);
  CHECK(row.comparisons[1].verdict() == Verdict::above);
  CHECK(row.comparisons[1].difference.interval->lower == doctest::Approx(0.01));
}

TEST_CASE("runs without a value are left out, one run has no interval and no verdict") {
  const std::array runs{run_with(0.6, 0.5), run_with({}, {}), run_with(0.8, {})};
  const auto row = summarize(runs).front();
  CHECK(row.ours.runs == 2);
  CHECK(*row.ours.mean == doctest::Approx(0.7));
  CHECK(row.comparisons[1].difference.runs == 1);
  CHECK(row.comparisons[1].verdict() == Verdict::unknown);
  const std::array none{run_with({}, {})};
  CHECK_FALSE(summarize(none).front().ours.mean);
  CHECK_FALSE(summarize(none).front().ours.interval);
  CHECK(summarize({}).empty());
}

TEST_CASE("sets are compared metric by metric, a metric that one set lacks is left out") {
  const std::array a{run_with(0.5, 0.5), run_with(0.52, 0.5), run_with(0.48, 0.5)};
  std::array b{run_with(0.6, 0.5), run_with(0.62, 0.5), run_with(0.58, 0.5)};
  const auto differences = compare_sets(a, b);
  REQUIRE(differences.size() == 1);
  CHECK(*differences[0].difference == doctest::Approx(0.1));
  CHECK(verdict(differences[0].interval) == Verdict::above);
  for (RunMetrics& run : b) run.measurements[0].name.species = "wolf";
  CHECK(compare_sets(a, b).empty());
  CHECK(compare_sets(a, {}).empty());
}

TEST_CASE("runs of different food webs are not pooled") {
  std::array runs{run_with(0.5, 0.5), run_with(0.5, 0.5)};
  runs[1].measurements[0].name.species = "wolf";
  CHECK_THROWS_AS(static_cast<void>(summarize(runs)), std::invalid_argument);
}
