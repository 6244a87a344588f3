// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/temporary_folder.hpp>
#include <tools/reading/lineages.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::analysis;
using test::message_of;

namespace {

const std::string lineage_header =
    "id,ancestor_list,ancestor_id,origin_time,destruction_time,species,origin,body,genome_id,mutation_distance,tag_at_birth,"
    "tag_at_death,cause_of_death,killer_id\n";

/// A prey that dies at 20 s and its living offspring; the row of the dead is first.
RunManifest written_lineages(const std::filesystem::path& folder) {
  std::ofstream{folder / "phylogeny.csv"} << lineage_header << "0,[none],0,0,20,prey,random,0,0,0,1,1,caught,5\n"
                                          << "5,[none],5,0,inf,predator,random,1,5,0,1,,,\n"
                                          << "7,[0],0,10,inf,prey,inherited,2,7,0.5,1,,,\n";
  std::ofstream{folder / "genomes.csv"} << "id,genome_id,time_s,w0,w1\n0,0,0,0.25,0.5\n5,5,0,1,2\n7,7,10,3,4\n";
  RunManifest run;
  run.folder = folder;
  run.status = "complete";
  run.reached_s = 30.0;
  run.policies["heredity"] = "own_copy";
  run.web = FoodWeb{{"prey", "predator"}, {{.hunter = 1, .victim = 0}}};
  return run;
}

}  // namespace

TEST_CASE("lineages: phylogeny and genomes -> individuals in the order of births, parents by place") {
  const test::TemporaryFolder folder;
  const Forest forest = read_lineages(written_lineages(folder.path()));
  REQUIRE(forest.size() == 3);
  CHECK(forest[1].id == 5);
  CHECK(forest[0].death_s == 20.0);
  CHECK(forest[1].species == 1);
  CHECK_FALSE(forest[1].parent);
  CHECK(*forest[2].parent == 0);
  CHECK(forest[2].death_s > 1e9);
  CHECK(forest[2].weights == std::vector{3.0, 4.0});
}

TEST_CASE("lineages: what a run cannot give -> error that names file and reason") {
  const test::TemporaryFolder folder;
  RunManifest run = written_lineages(folder.path());
  const auto error = [&] { return message_of<std::invalid_argument>([&] { static_cast<void>(read_lineages(run)); }); };
  const auto file = [&](const char* name) { return (folder.path() / name).string(); };
  CHECK(error() == "");
  run.policies["heredity"] = "shared_copy";
  CHECK(error() == file("genomes.csv") +
                       ": rule heredity = shared_copy: must give each individual a genome of its own, as "
                       "own_copy; a genome that several share changes after birth");
  run = written_lineages(folder.path());
  run.reached_s.reset();
  run.status = "running";
  CHECK(error() ==
        file("manifest.json") + ": status \"running\": phylogeny.csv has those alive only at a run's end; resume the run");
  run = written_lineages(folder.path());
  std::ofstream{folder.path() / "genomes.csv"} << "id,genome_id,time_s,w0\n0,0,0,1\n5,0,0,1\n7,7,10,3\n";
  CHECK(error().find("a genome that several share") != std::string::npos);
  std::ofstream{folder.path() / "genomes.csv"} << "id,genome_id,time_s,w0\n0,0,0,1\n5,5,0,1\n";
  CHECK(error() == file("genomes.csv") + ": has no genome of individual 7");
  std::filesystem::remove(folder.path() / "genomes.csv");
  CHECK(error() == file("genomes.csv") + ": is missing: lineage measures need phylogeny and genomes");
  run = written_lineages(folder.path());
  std::ofstream{folder.path() / "phylogeny.csv"} << lineage_header << "7,[0],0,10,inf,prey,inherited,2,7,0.5,1,,,\n";
  CHECK(error() == file("phylogeny.csv") + ": id 7: its parent 0 is not among those born before it");
}

TEST_CASE("lineages: a row of phylogeny.csv that no run writes -> error that names the individual") {
  struct Case {
    const char* row;
    const char* what;
  };
  for (const Case& one :
       {Case{"7,[0],0,-1,inf,prey,inherited,2,7,0.5,1,,,", "id 7: origin_time = -1: must be >= 0 and <= 30, the run's end"},
        Case{"7,[0],0,31,inf,prey,inherited,2,7,0.5,1,,,", "id 7: origin_time = 31: must be >= 0 and <= 30, the run's end"},
        Case{"7,[0],0,10,9,prey,inherited,2,7,0.5,1,,,", "id 7: destruction_time = 9: must be >= its origin_time, 10, and <= 30"},
        Case{"7,[0],0,10,31,prey,inherited,2,7,0.5,1,,,", "id 7: destruction_time = 31: must be >= its origin_time, 10"},
        Case{"7,[5],0,10,inf,prey,inherited,2,7,0.5,1,,,", "id 7: ancestor_list = [5]: must be [0], as its ancestor_id"},
        Case{"5,[none],5,10,inf,prey,inherited,2,7,0.5,1,,,", "id 5: has two rows"}}) {
    CAPTURE(one.row);
    const test::TemporaryFolder folder;
    const RunManifest run = written_lineages(folder.path());
    std::ofstream{folder.path() / "phylogeny.csv", std::ios::app} << one.row << "\n";
    const std::string error = message_of<std::invalid_argument>([&] { static_cast<void>(read_lineages(run)); });
    CHECK(error.find((folder.path() / "phylogeny.csv").string() + ": " + one.what) == 0);
  }
}

TEST_CASE("parents in a list -> none, one or more, and nothing from another text") {
  using Parents = std::vector<IndividualId>;
  CHECK(parents_in("[none]") == Parents{});
  CHECK(parents_in("[7]") == Parents{7});
  CHECK(parents_in("[7,9,12]") == Parents{7, 9, 12});
  for (const char* text : {"", "7", "[]", "[7", "[7,]", "[7;9]", "[-1]", "[none,7]"}) CHECK_FALSE(parents_in(text));
}
