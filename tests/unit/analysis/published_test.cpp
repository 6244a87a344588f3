// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>
#include <tools/analysis/metrics/run_metrics.hpp>
#include <tools/analysis/report/claim_conclusion.hpp>
#include <tools/analysis/report/published.hpp>
#include <unit/reading/rows.hpp>

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

TEST_CASE("published: a metric that only the logs count in another way -> none, another reading of a claim -> its number") {
  CHECK(*published({"velocity", "prey", "active", "m/s"}) == -0.0067);
  CHECK(*published({"velocity_points", "predator", "inherited", "m/s"}) == 0.0195);
  CHECK(*published({"wall_sticking_gap", "prey-predator", "active", "1"}) == 0.21);
  CHECK_FALSE(published({"attribution_died", "prey", "all", "1"}));
}

TEST_CASE("claims: every reading -> a metric that a run of the paper's food web has, and words unlike those of the others") {
  analysis::RunData run;
  run.manifest.web = test::prey_and_predators;
  run.manifest.half_side_m = 10.0;
  run.manifest.until_s = 6000.0;
  const auto measured = analysis::measure_run(run).measurements;
  for (const analysis::Claim& claim : analysis::claims) {
    std::set<std::string> words;
    for (const analysis::ClaimReading& reading : claim.readings) {
      CAPTURE(reading.metric);
      CHECK(std::ranges::find(measured, analysis::metric_of(reading), &analysis::Measurement::name) != measured.end());
      CHECK(analysis::margin_of(reading).value_or(1.0) > 0.0);
      words.insert(std::string{reading.members} + "|" + std::string{reading.counting});
    }
    CAPTURE(claim.title);
    CHECK(words.size() == claim.readings.size());
    CHECK((claim.readings.size() == 1) == (*words.begin() == "|"));
  }
}
