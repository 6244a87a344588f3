// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <support/temporary_folder.hpp>
#include <tools/analysis/report/summary_json.hpp>
#include <unit/reading/run_files.hpp>
#include <vector>

using namespace trophic;
using test::TemporaryFolder;

TEST_CASE("summary.json has null for what could not be computed, and no interval nor conclusion of one run") {
  const TemporaryFolder folder;
  const std::vector runs{test::write_run(folder.path() / "one", test::manifest("aa", 5))};
  const auto set = analysis::read_shadowed_set(runs);
  const auto json = analysis::summary_json(set, analysis::summarize(set.ours.runs));
  CHECK(json["set"] == "paper");
  CHECK(json["runs"][0]["seed"] == 5);
  CHECK(json["shadow_runs"].empty());
  for (const auto& metric : json["metrics"]) {
    CHECK(metric["lower"].is_null());
    CHECK(metric["deviation"].is_null());
    if (metric["metric"] == "velocity") CHECK(metric["mean"].is_null());
    if (metric["metric"] == "attribution_caught") {
      CHECK(metric["mean"] == 1.0);
      CHECK(metric["published"] == 0.65);
      CHECK(metric["baselines"][0]["role"] == "paper");
      CHECK(metric["baselines"][0]["conclusion"].is_null());
    }
  }
  REQUIRE(json["claims"].size() == analysis::claims.size());
  for (const auto& claim : json["claims"]) {
    CHECK(claim["summary"].get<std::string>().starts_with("no conclusion"));
    for (const auto& reading : claim["readings"]) {
      CHECK(reading["conclusion"] == "no conclusion");
      CHECK(reading["margin"].is_number());
      CHECK(reading["margin_from"].is_string());
      CHECK(reading["difference_lower"].is_null());
    }
  }
  const auto differences = analysis::differences_json(analysis::compare_sets(set, set));
  CHECK(differences[0]["raw"]["value"] == 0.0);
  CHECK(differences[0]["raw"]["lower"].is_null());
  CHECK(differences[0]["raw"]["differs"].is_null());
  CHECK(differences[0]["over_shadow"]["value"].is_null());
}

TEST_CASE("summary.json has the shadow's runs, and the shadow as the first baseline") {
  const TemporaryFolder folder;
  auto set = analysis::read_shadowed_set(std::vector{test::write_run(folder.path() / "one", test::manifest("aa", 5))});
  set.shadow = analysis::read_set(std::vector{test::write_run(folder.path() / "two", test::manifest("bb", 5), "random")});
  const auto json = analysis::summary_json(set, analysis::summarize(set.ours.runs, set.shadow_runs()));
  CHECK(json["shadow_runs"].size() == 1);
  CHECK(json["metrics"][0]["baselines"][0]["name"] == "shadow");
}
