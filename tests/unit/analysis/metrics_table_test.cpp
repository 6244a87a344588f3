// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <array>
#include <iterator>
#include <support/temporary_folder.hpp>
#include <tools/analysis/report/metrics_table.hpp>
#include <unit/reading/run_files.hpp>
#include <vector>

using namespace trophic;
using test::TemporaryFolder;

TEST_CASE("metrics.csv: metrics -> one value a row, with an empty cell for a value that could not be computed") {
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

TEST_CASE("metrics.csv: set with a shadow -> the shadow's values in the same rows, as baseline shadow") {
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
}
