// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/temporary_folder.hpp>
#include <tools/reading/table_reader.hpp>
#include <trophic/io/csv.hpp>
#include <trophic/io/tables.hpp>
#include <vector>

namespace {

using namespace trophic;
using test::message_of;
using test::TemporaryFolder;

const FoodWeb web{{"prey", "predator"}, {{.hunter = 1, .victim = 0}}};

template <class Row>
std::string line_of(const Row& row) {
  std::string text;
  io::append_row(text, row, web);
  return text;
}

/// Writes rows and reads them back: the same lines.
template <class Row>
void check_round_trip(const std::vector<Row>& rows) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "t.csv";
  {
    io::CsvFile<Row> file{path, rows.front()};
    for (const Row& row : rows) file.write(row, web);
    file.flush();
  }
  analysis::TableReader<Row> table{path, web};
  for (const Row& row : rows) {
    Row read;
    REQUIRE(table.next(read));
    CHECK(line_of(read) == line_of(row));
  }
  Row none;
  CHECK_FALSE(table.next(none));
  CHECK_FALSE(table.csv().truncated());
}

}  // namespace

TEST_CASE("every table of a run reads back as it was written") {
  check_round_trip<io::EventRow>(
      {{.time_s = 4.0, .tick = 2, .kind = observe::EventKind::capture, .id = 3, .species = 1, .victim = 5, .x_m = -0.123456},
       {.kind = observe::EventKind::death,
        .active = false,
        .origin = Origin::inherited,
        .parent = 7,
        .cause = Cause::caught,
        .killer = 3}});
  check_round_trip<io::EventRow>({{.id = 3, .ancestor_list = "[none]"}, {.id = 4, .parent = 3, .ancestor_list = "[3,2]"}});
  check_round_trip<io::AgentRow>(
      {{.id = 9, .tag = -1, .adversary = 4, .adversary_distance_m = 1.5, .hunger_ticks = 3}, {.species = 1}});
  check_round_trip<io::AgentRow>({{.id = 9, .energy_J = 31.25, .own = {{"sight_m", "rest"}, {6.5, 1.0}}}});
  check_round_trip<io::TaxonRow>(
      {{.id = 1, .ancestor_list = "[none]", .destruction_time = 2.5, .tag_at_death = -1, .cause_of_death = Cause::starved},
       {.id = 2, .ancestor_list = "[1,0]", .mutation_distance = 1.0 / 3.0}});
  check_round_trip<io::TaxonRow>({{.id = 2, .ancestor_list = "[1]", .ancestor = 1}});
  check_round_trip<io::GenomeRow>({{.id = 1, .weights = {0.1, -1.0 / 3.0}}, {.id = 2, .weights = {1e-300, 2.0}}});
  check_round_trip<io::GenomeRow>({{.id = 1, .weights = {0.5}, .traits = {{"sight_m", "w_m"}, {6.0, 1.0 / 3.0}}}});
}

TEST_CASE("columns may stand in any order and among others, but none may be missing") {
  const TemporaryFolder folder;
  const std::string path = folder.file("t.csv", "time_s,w0,sight_m,genome_id,w1,id\n2,0.5,6,7,1,3\n2,0.5,6,8,,4\n2,,6,9,1,5\n");
  analysis::TableReader<io::GenomeRow> table{path, web};
  io::GenomeRow row;
  REQUIRE(table.next(row));
  CHECK(row.id == 3);
  CHECK(row.genome == 7);
  CHECK(row.weights == std::vector{0.5, 1.0});
  CHECK(row.traits.names == std::vector<std::string>{"sight_m"});
  CHECK(row.traits.values == std::vector{6.0});
  REQUIRE(table.next(row));
  CHECK(row.weights == std::vector{0.5});  // of a species with a smaller brain
  CHECK(message_of<std::runtime_error>([&] { table.next(row); }) == path + ":4: w0 = \"\": must be a number");
  const std::string lacking = folder.file("u.csv", "time_s,id\n");
  CHECK(message_of<std::runtime_error>([&] {
          analysis::TableReader<io::GenomeRow>{lacking, web};
        }) == lacking + ":1: no column \"genome_id\"; another kind of file?");
}

TEST_CASE("table reader: cell that is not a value of its column -> refused with line and column") {
  const TemporaryFolder folder;
  const std::string path = folder.file("t.csv", "id,genome_id,time_s,w0\n1,2,3,big\n");
  analysis::TableReader<io::GenomeRow> table{path, web};
  io::GenomeRow row;
  CHECK(message_of<std::runtime_error>([&] { table.next(row); }) == path + ":2: w0 = \"big\": must be a number");
  CHECK(message_of<std::runtime_error>([&] { table.reject("time_s", "less"); }) == path + ":2: time_s = \"3\": must be less");
}
