// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/temporary_folder.hpp>
#include <tools/reading/checked_rows.hpp>
#include <tools/reading/lineages.hpp>
#include <trophic/io/tables.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::analysis;
using test::message_of;

namespace {

const std::string further_columns =
    "origin_time,destruction_time,species,origin,body,genome_id,mutation_distance,tag_at_birth,tag_at_death,cause_of_death,"
    "killer_id\n";

}  // namespace

TEST_CASE("lineages: a row of phylogeny.csv that no run writes -> error that names the individual") {
  struct Case {
    const char* row;
    const char* what;
    const char* first_columns = "id,ancestor_list,ancestor_id,";
  };
  for (const Case& one :
       {Case{"7,[0],0,-1,inf,prey,inherited,2,7,0.5,1,,,", "id 7: origin_time = -1: must be >= 0 and <= 30, the run's end"},
        Case{"7,[0],0,31,inf,prey,inherited,2,7,0.5,1,,,", "id 7: origin_time = 31: must be >= 0 and <= 30, the run's end"},
        Case{"7,[0],0,10,9,prey,inherited,2,7,0.5,1,,,", "id 7: destruction_time = 9: must be >= its origin_time, 10, and <= 30"},
        Case{"7,[0],0,10,31,prey,inherited,2,7,0.5,1,,,", "id 7: destruction_time = 31: must be >= its origin_time, 10"},
        Case{"7,[5],0,10,inf,prey,inherited,2,7,0.5,1,,,", "id 7: ancestor_list = [5]: must be [0], as its ancestor_id"},
        Case{"7,\"[0,5]\",0,10,inf,prey,inherited,2,7,0.5,1,,,", "id 7: ancestor_list = [0,5]: must be [0], as its ancestor_id"},
        Case{"7,\"[0,]\",10,inf,prey,inherited,2,7,0.5,1,,,",
             "id 7: ancestor_list = [0,]: must be [none] or its parents, as [7,9]", "id,ancestor_list,"},
        Case{"7,\"[0,5]\",10,9,prey,inherited,2,7,0.5,1,,,", "id 7: destruction_time = 9: must be", "id,ancestor_list,"}}) {
    CAPTURE(one.row);
    const test::TemporaryFolder folder;
    RunManifest run;
    run.folder = folder.path();
    run.reached_s = 30.0;
    run.web = FoodWeb{{"prey", "predator"}, {{.hunter = 1, .victim = 0}}};
    std::ofstream{folder.path() / "phylogeny.csv"} << one.first_columns << further_columns << one.row << "\n";
    const auto check = [&](const io::TaxonRow& row) { check_taxon(row, run); };
    const std::string error = message_of<std::invalid_argument>([&] { for_each_row<io::TaxonRow>(run, "phylogeny.csv", check); });
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
