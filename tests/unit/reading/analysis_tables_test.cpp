// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <array>
#include <support/temporary_folder.hpp>
#include <tools/trophic/analysis_tables.hpp>
#include <trophic/support/whole_file.hpp>
#include <unit/reading/run_files.hpp>

using namespace trophic;
using test::message_of;

namespace {

/// A run of two species whose bodies.csv has these rows.
std::filesystem::path with_bodies(const std::filesystem::path& folder, const std::string& rows) {
  test::write_run(folder, test::manifest("a", 1));
  std::ofstream{folder / "bodies.csv"} << "id,time_s,species,modules_text\n" << rows;
  return folder;
}

}  // namespace

TEST_CASE("plan distances: replicates in a folder -> each plan to the first one of its species, by id") {
  const test::TemporaryFolder folder;
  const auto run = with_bodies(folder.path() / "study/replicate-00",
                               "0,0,prey,core[left:hinge0]\n1,0,predator,core\n4,9,prey,core[left:hinge0 right:hinge0]\n"
                               "2,9,prey,core\n3,9,predator,core\n");
  const auto file = folder.path() / "distances.csv";
  command::write_plan_distances(file, std::array{folder.path() / "study"});
  std::string expected = "run,id,distance\n";
  for (const char* row : {"0,0", "1,0", "2,1", "3,0", "4,1"}) expected += run.string() + "," + row + "\n";
  CHECK(read_whole_file(file) == expected);
  CHECK_THROWS_AS(command::write_plan_distances(file, std::array{run}), std::runtime_error);
}

TEST_CASE("plan distances: a plan that cannot be read -> one sentence that names file and individual") {
  const test::TemporaryFolder folder;
  const auto run = with_bodies(folder.path() / "run", "7,0,prey,core[left\n");
  const auto error =
      message_of<std::invalid_argument>([&] { command::write_plan_distances(folder.path() / "distances.csv", std::array{run}); });
  CHECK(error.find((run / "bodies.csv").string() + ": id 7: body plan \"core[left") == 0);
  CHECK_FALSE(std::filesystem::exists(folder.path() / "distances.csv"));
}
