// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/temporary_folder.hpp>
#include <tools/reading/checked_rows.hpp>
#include <trophic/io/tables.hpp>

using namespace trophic;

TEST_CASE("checked rows: whole table -> each row, truncated one -> refused in one sentence") {
  const test::TemporaryFolder folder;
  const std::string whole = "id,genome_id,time_s,w0\n1,2,3,0.5\n2,2,4,0.25\n";
  analysis::RunManifest run;
  run.folder = folder.path();
  run.web = FoodWeb{{"prey"}, {}};
  const auto read = [&](const std::string& content) {
    static_cast<void>(folder.file("genomes.csv", content));
    std::size_t rows = 0;
    analysis::for_each_row<io::GenomeRow>(run, "genomes.csv", [&](const io::GenomeRow&) { ++rows; });
    return rows;
  };
  CHECK(read(whole) == 2);
  const std::string path = (folder.path() / "genomes.csv").string();
  CHECK(test::message_of<std::invalid_argument>([&] { static_cast<void>(read(whole.substr(0, whole.size() - 2))); }) ==
        path + ": the last line is truncated; resume the run");
}
