// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/temporary_folder.hpp>
#include <tools/analysis/metrics/run_set.hpp>
#include <unit/reading/run_files.hpp>

namespace {

using namespace trophic::analysis;
namespace test = trophic::test;

struct Measured {
  RunMetrics metrics;
  std::vector<std::string> remarks;
};

Measured measured(const std::string& table, const std::string& column = "own.csv:x", double until_s = 6000.0) {
  const test::TemporaryFolder folder;
  std::ofstream{folder.path() / "own.csv"} << table;
  RunData run;
  run.manifest.folder = folder.path();
  run.manifest.until_s = until_s;
  Measured result;
  measure_column(own_column_of(column), run, result.metrics, result.remarks);
  return result;
}

}  // namespace

TEST_CASE("own column: FILE:COLUMN with or without a unit -> read, anything else -> one sentence") {
  CHECK(own_column_of("crowd.csv:close").unit == "1");
  CHECK(own_column_of("crowd.csv:close:robots").unit == "robots");
  for (const char* text : {"crowd.csv", "crowd.csv:", "crowd.csv:a:", "crowd.csv:a:b:c", ":close", "../crowd.csv:close"}) {
    CAPTURE(text);
    CHECK(test::message_of<std::invalid_argument>([&] {
            static_cast<void>(own_column_of(text));
          }).starts_with("--column " + std::string{text} + ": must "));
  }
}

TEST_CASE("measure_column: a table with times -> the mean over rows and a curve of windows, without empty cells and nan") {
  const Measured found = measured("time_s,x\n0,1\n100,3\n200,nan\n300,\n400,8\n");
  REQUIRE(found.metrics.measurements.size() == 1);
  CHECK(found.metrics.measurements[0].name == MetricName{"x", "", "all", "1"});
  CHECK(*found.metrics.measurements[0].value == 4.0);
  REQUIRE(found.metrics.curves[0].points.size() == 2);
  CHECK(*found.metrics.curves[0].points[0].value == 2.0);
  CHECK(*found.metrics.curves[0].points[1].value == 8.0);
  CHECK(*measured("time_s,x\n0,1\n100,3\n400,8\n", "own.csv:x", 100.0).metrics.measurements[0].value == 2.0);
}

TEST_CASE("measure_column: rows of species and groups -> a metric each") {
  const Measured found = measured("species,group,x\nprey,all,1\npredator,all,2\nprey,all,3\n");
  REQUIRE(found.metrics.measurements.size() == 2);
  CHECK(found.metrics.measurements[0].name.species == "prey");
  CHECK(*found.metrics.measurements[0].value == 2.0);
  CHECK(found.metrics.curves.empty());
}

TEST_CASE("measure_column: a run without any value -> a remark, and no mean") {
  const Measured found = measured("x\nnan\nnan\n");
  CHECK_FALSE(found.metrics.measurements[0].value);
  REQUIRE(found.remarks.size() == 1);
  CHECK(found.remarks[0].ends_with("x has no value; the run is left out of its mean"));
}

TEST_CASE("measure_column: no such column, no number, infinity, no file -> errors that name the file") {
  CHECK_THROWS_WITH_AS(measured("y\n1\n"), doctest::Contains("own.csv:1: no column \"x\""), std::runtime_error);
  CHECK_THROWS_WITH_AS(measured("x\nmany\n"), doctest::Contains("own.csv:2: x = \"many\": must be a number"), std::runtime_error);
  CHECK_THROWS_WITH_AS(measured("x\ninf\n"), doctest::Contains("must be finite"), std::runtime_error);
  CHECK_THROWS_WITH_AS(measured("x\n1\n", "other.csv:x"), doctest::Contains("has no such file"), std::invalid_argument);
}

TEST_CASE("read_set: a column of one's own is measured in each run, on any number of threads") {
  const test::TemporaryFolder folder;
  std::vector<std::filesystem::path> paths;
  for (int run = 0; run < 7; ++run) {
    paths.push_back(test::write_run(folder.path() / std::to_string(run), test::manifest("aa", run)));
    std::ofstream{paths.back() / "own.csv"} << "species,x\nprey," << run << (run == 3 ? "\nbird,1\n" : "\n");
  }
  std::size_t calls = 0;
  const Measuring how{.until_s = {}, .columns = {own_column_of("own.csv:x")}, .jobs = 3, .on_run = [&] { ++calls; }};
  const RunSet set = read_set(paths, how);
  CHECK(calls == 7);
  CHECK(values_of(set.runs, {"x", "prey", "all", "1"}) == std::vector<double>{0, 1, 2, 3, 4, 5, 6});
  CHECK(values_of(set.runs, {"x", "bird", "all", "1"}) == std::vector<double>{1});
  for (const RunMetrics& run : set.runs) CHECK(run.measurements.size() == set.runs[0].measurements.size());
}
