// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <array>
#include <support/temporary_folder.hpp>
#include <tools/analysis/report/metrics_table.hpp>
#include <tools/analysis/report/table_file.hpp>
#include <trophic/io/csv.hpp>
#include <trophic/support/whole_file.hpp>

using namespace trophic;
using analysis::MetricRow;

TEST_CASE("table file: complete -> gets its name, abandoned -> removed") {
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "table.csv";
  const std::filesystem::path part = folder.path() / "table.csv.part";
  const std::array rows{MetricRow{.set = "one", .value = 1.5}, MetricRow{.set = "two, three", .time_s = 100.0}};
  {
    analysis::TableFile<MetricRow> table{path};
    table.write(rows[0]);
    table.flush();
    CHECK(read_whole_file(part) == io::table_text<MetricRow>(std::array{rows[0]}));
    CHECK_FALSE(std::filesystem::exists(path));
  }
  CHECK(std::filesystem::is_empty(folder.path()));

  analysis::TableFile<MetricRow> table{path};
  for (const MetricRow& row : rows) table.write(row);
  table.finish();
  CHECK(read_whole_file(path) == io::table_text<MetricRow>(rows));
  CHECK_FALSE(std::filesystem::exists(part));
  CHECK_THROWS_AS(analysis::TableFile<MetricRow>{path}, std::runtime_error);
}
