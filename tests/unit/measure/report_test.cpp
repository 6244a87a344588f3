// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <array>
#include <fstream>
#include <iterator>
#include <string>
#include <support/temporary_folder.hpp>
#include <trophic/measure/report.hpp>
#include <unit/measure/run_files.hpp>
#include <vector>

using namespace trophic;
using test::TemporaryFolder;

TEST_CASE("metrics.csv is tidy: one value a row, an empty cell for what could not be computed") {
  const TemporaryFolder folder;
  const std::vector runs{test::write_run(folder.path() / "one,two", test::manifest("aa", 5))};
  const std::array sets{measure::read_set(runs)};
  measure::write_metrics(folder.path() / "metrics.csv", sets);
  std::ifstream file{folder.path() / "metrics.csv"};
  const std::string text{std::istreambuf_iterator<char>{file}, {}};
  CHECK(text.starts_with("set,run,seed,metric,species,group,baseline,time_s,value,unit\n"));
  const auto has = [&](const char* row) {
    return text.find(std::string{"\npaper,one_two,5,"} + row + "\n") != std::string::npos;
  };
  CHECK(has("attribution_caught,prey,all,,,1,1"));
  CHECK(has("attribution_caught,prey,all,share_alive,,1,1"));
  CHECK(has("wall_sticking,prey,all,,,1,1"));
  CHECK(has("wall_sticking,prey,all,,200,1,1"));
  CHECK(has("velocity,prey,random,,,,m/s"));
  CHECK_THROWS_AS(measure::write_metrics(folder.path() / "metrics.csv", sets), std::runtime_error);
}

TEST_CASE("summary.json has null for what could not be computed, and no interval of one run") {
  const TemporaryFolder folder;
  const std::vector runs{test::write_run(folder.path() / "one", test::manifest("aa", 5))};
  const auto set = measure::read_set(runs);
  const auto json = measure::summary_json(set, measure::summarize(set.runs));
  CHECK(json["set"] == "paper");
  CHECK(json["runs"][0]["seed"] == 5);
  for (const auto& metric : json["metrics"]) {
    CHECK(metric["lower"].is_null());
    if (metric["metric"] == "velocity") CHECK(metric["mean"].is_null());
    if (metric["metric"] == "attribution_caught") {
      CHECK(metric["mean"] == 1.0);
      CHECK(metric["published"] == 0.65);
      CHECK(metric["baselines"][0]["verdict"] == "unknown");
    }
  }
  const auto differences = measure::differences_json(measure::compare_sets(set.runs, set.runs));
  CHECK(differences[0]["difference"] == 0.0);
  CHECK(differences[0]["lower"].is_null());
}
