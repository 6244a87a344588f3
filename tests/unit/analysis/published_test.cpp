// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <trophic/analysis/metrics/run_metrics.hpp>
#include <trophic/analysis/report/published.hpp>
#include <unit/analysis/rows.hpp>

using namespace trophic;
using analysis::published;

TEST_CASE("the paper's numbers, in SI units, positive towards the adversary, none for what it did not publish") {
  CHECK(*published({"attribution_credited", "predator", "all", "1"}) == 0.725);
  CHECK(*published({"attribution_caught", "prey", "all", "1"}) == 0.65);
  CHECK(*published({"velocity_stored", "prey", "all", "m/s"}) == -0.0067);
  CHECK(*published({"tag_symmetry", "prey+predator", "inherited", "1"}) == 0.43);
  CHECK(*published({"velocity", "predator", "all", "m/s"}) == 0.0195);
  CHECK_FALSE(published({"attribution_catches", "predator", "all", "1"}));
  CHECK_FALSE(published({"attribution_catchers", "predator", "all", "1"}));
  CHECK_FALSE(published({"velocity", "prey", "random", "m/s"}));
  CHECK_FALSE(published({"wall_sticking", "wolf", "all", "1"}));
}

TEST_CASE("every claim is about a metric that a run of the paper's food web has, with a margin") {
  analysis::RunData run;
  run.manifest.web = test::prey_and_predators;
  run.manifest.half_side_m = 10.0;
  run.manifest.until_s = 6000.0;
  const auto measured = analysis::measure_run(run).measurements;
  for (const analysis::Claim& claim : analysis::claims) {
    CAPTURE(claim.metric);
    CHECK(std::ranges::find(measured, analysis::metric_of(claim), &analysis::Measurement::name) != measured.end());
    CHECK(claim.margin > 0.0);
  }
  CHECK_FALSE(analysis::claims.front().second_line);
}
