// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/temporary_folder.hpp>
#include <tools/reading/checked_rows.hpp>
#include <trophic/io/tables.hpp>
#include <trophic/support/checksum.hpp>

using namespace trophic;

TEST_CASE("checked rows: table as it was written -> each row, changed or truncated -> refused in one sentence") {
  const test::TemporaryFolder folder;
  const std::string whole = "id,genome_id,time_s,w0\n1,2,3,0.5\n2,2,4,0.25\n";
  analysis::RunManifest run;
  run.folder = folder.path();
  run.web = FoodWeb{{"prey"}, {}};
  const auto read = [&](const std::string& content, io::TableSum sum) {
    static_cast<void>(folder.file("genomes.csv", content));
    run.tables["genomes.csv"] = sum;
    std::size_t rows = 0;
    analysis::for_each_row<io::GenomeRow>(run, "genomes.csv", [&](const io::GenomeRow&) { ++rows; });
    return rows;
  };
  CHECK(read(whole, {.rows = 2, .crc32 = checksum(whole)}) == 2);
  const std::string path = (folder.path() / "genomes.csv").string();
  const auto refused = [&](const std::string& content, io::TableSum sum) {
    return test::message_of<std::invalid_argument>([&] { static_cast<void>(read(content, sum)); });
  };
  CHECK(refused(whole, {.rows = 3, .crc32 = checksum(whole)}).starts_with(path + ": has 2 rows and checksum "));
  const std::string cut = whole.substr(0, whole.size() - 2);
  CHECK(refused(cut, {.rows = 1, .crc32 = checksum(cut)}) == path + ": the last line is truncated; resume the run");
}
