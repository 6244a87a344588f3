// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <array>
#include <fstream>
#include <iterator>
#include <string>
#include <support/temporary_folder.hpp>
#include <trophic/analysis/report/report.hpp>
#include <unit/analysis/run_files.hpp>
#include <vector>

using namespace trophic;
using test::TemporaryFolder;

TEST_CASE("metrics.csv is tidy: one value a row, an empty cell for what could not be computed") {
  const TemporaryFolder folder;
  const std::vector runs{test::write_run(folder.path() / "one,two", test::manifest("aa", 5))};
  const std::array sets{analysis::read_shadowed_set(runs)};
  analysis::write_metrics(folder.path() / "metrics.csv", sets);
  std::ifstream file{folder.path() / "metrics.csv"};
  const std::string text{std::istreambuf_iterator<char>{file}, {}};
  CHECK(text.starts_with("set,run,seed,metric,species,group,baseline,time_s,value,unit\n"));
  const auto has = [&](const char* row) {
    return text.find(std::string{"\npaper,one_two,5,"} + row + "\n") != std::string::npos;
  };
  CHECK(has("attribution_caught,prey,all,,,1,1"));
  CHECK(has("attribution_caught,prey,all,two_thirds,,0.6666666666666666,1"));
  CHECK(has("wall_sticking,prey,all,,,1,1"));
  CHECK(has("wall_sticking,prey,all,,200,1,1"));
  CHECK(has("velocity,prey,random,,,,m/s"));
  CHECK_THROWS_AS(analysis::write_metrics(folder.path() / "metrics.csv", sets), std::runtime_error);
}

TEST_CASE("a shadow's observations stand beside those of its set as baseline \"shadow\"") {
  const TemporaryFolder folder;
  const std::vector runs{test::write_run(folder.path() / "one", test::manifest("aa", 5))};
  std::array sets{analysis::read_shadowed_set(runs)};
  sets[0].shadow = analysis::read_set(std::vector{test::write_run(folder.path() / "two", test::manifest("bb", 5), "random")});
  analysis::write_metrics(folder.path() / "metrics.csv", sets);
  std::ifstream file{folder.path() / "metrics.csv"};
  const std::string text{std::istreambuf_iterator<char>{file}, {}};
  CHECK(text.find("\npaper,one,5,attribution_catches,predator,all,,,1,1\n") != std::string::npos);
  CHECK(text.find("\npaper,two,5,attribution_catches,predator,all,shadow,,0,1\n") != std::string::npos);
  CHECK(text.find("\npaper,two,5,attribution_catches,predator,all,two_thirds") == std::string::npos);
  CHECK(text.find("\npaper,two,5,wall_sticking,prey,all,shadow,200,1,1\n") != std::string::npos);
  const auto json = analysis::summary_json(sets[0], analysis::summarize(sets[0].ours.runs, sets[0].shadow_runs()));
  CHECK(json["shadow_runs"].size() == 1);
  CHECK(json["metrics"][0]["baselines"][0]["name"] == "shadow");
}

TEST_CASE("summary.json has null for what could not be computed, and no interval nor verdict of one run") {
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
      CHECK(metric["baselines"][0]["verdict"].is_null());
    }
  }
  REQUIRE(json["claims"].size() == analysis::claims.size());
  for (const auto& claim : json["claims"]) CHECK(claim["verdict"] == "no verdict");
  const auto differences = analysis::differences_json(analysis::compare_sets(set, set));
  CHECK(differences[0]["raw"]["value"] == 0.0);
  CHECK(differences[0]["raw"]["lower"].is_null());
  CHECK(differences[0]["raw"]["differs"].is_null());
  CHECK(differences[0]["over_shadow"]["value"].is_null());
}
