// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <span>
#include <support/temporary_folder.hpp>
#include <tools/analysis/metrics/lineage_metrics.hpp>
#include <unit/reading/forests.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::analysis;
using doctest::Approx;
using trophic::test::alive;
using trophic::test::one;

namespace {

/// The type of a genome is its weight rounded down, from 0 to 3.
Signatures by_weight() {
  const auto decide = [](std::span<const double> inputs, std::span<const double> weights) {
    return control::Decision{.target_angle_rad = weights[0] - inputs[0], .tag = 1};
  };
  return {decide, {{{0.999}, {1.999}, {2.999}}, {{0.0}}}};
}

const FoodWeb lineage_web{{"prey", "predator"}, {{.hunter = 1, .victim = 0}}};

const Measurement& measured(const RunMetrics& metrics, const std::string& metric, const std::string& group) {
  const MetricName* found = nullptr;
  for (const Measurement& each : metrics.measurements) {
    found = &each.name;
    if (found->metric == metric && found->species == "prey" && found->group == group) return each;
  }
  throw std::invalid_argument{metric + " is not measured"};
}

}  // namespace

TEST_CASE("lineage metrics: a chain in which each birth has one possible parent -> drift equals the run") {
  const Forest chain{one({}, 0.0, 12.0, 0.0), one(0, 10.0, 22.0, 1.0), one(1, 20.0, 32.0, 2.0), one(2, 30.0, alive, 3.0)};
  Signatures signatures = by_weight();
  const RunMetrics metrics = lineage_metrics(chain, lineage_web, signatures, 10.0, 40.0, 1);
  // Windows end at 10, 20, 30 and 40 s; 0, 1, 2 and 3 persist in turn, 0 in the first.
  CHECK(*measured(metrics, "modes_novelty", "late").value == Approx(1.0));
  CHECK(*measured(metrics, "modes_ecology", "late").value == Approx(0.0));
  CHECK(*measured(metrics, "descent_mean_depth", "all").value == Approx((0.5 + 1.5 + 2.5 + 3.0) / 4.0));
  CHECK(*measured(metrics, "descent_roots", "all").value == Approx(1.0));
  CHECK(measured(metrics, "activity_mean", "early").name.unit == "s");
  for (const Measurement& each : metrics.measurements) {
    REQUIRE(each.baselines.size() == 1);
    CHECK(each.baselines[0].role == Role::null);
    if (each.value) CHECK(*each.baselines[0].value == Approx(*each.value));
  }
}

TEST_CASE("lineage metrics: names -> those of an empty forest, each once") {
  auto names = lineage_metric_names(lineage_web);
  CHECK(names.size() == 2 * (2 * 8 + 7));
  std::ranges::sort(names);
  CHECK(std::ranges::adjacent_find(names) == names.end());
}

TEST_CASE("lineage metrics: window -> a quarter of a short run by default, and no more") {
  using trophic::test::message_of;
  CHECK(default_window_s(6000.0) == 500.0);
  CHECK(default_window_s(100.0) == 25.0);
  check_window(25.0, 100.0);
  CHECK(message_of<std::invalid_argument>([] { check_window(26.0, 100.0); }) ==
        "--window 26: must be > 0 and <= 25, a quarter of the runs");
  CHECK_THROWS_AS(check_window(0.0, 100.0), std::invalid_argument);
}
