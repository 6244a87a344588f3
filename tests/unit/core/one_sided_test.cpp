// SPDX-License-Identifier: MIT
// The one-sided world: one species inherits nothing, the others do.
#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <set>
#include <support/hand_population.hpp>
#include <support/temporary_folder.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/reproduction/heredity/switched.hpp>
#include <trophic/rules/by_species.hpp>
#include <trophic/worlds/pond.hpp>
#include <unit/checkpoint/resumed.hpp>

using namespace trophic;
using namespace trophic::test;
using worlds::Pond;

namespace {

using reproduction::heredity::OwnCopy;
using reproduction::heredity::Switched;
template <class Table>
using BySide = with_heredity<Table, rules::by_species<Switched<OwnCopy>>>;

const Null without_prey{Null::one_sided, "prey"};

/// 800 s of a table, in which both species are born.
template <class Rules>
Experiment<Rules> short_run(const Null& null = {}) {
  Experiment<Rules> experiment{.seed = 5, .null = null};
  experiment.ecology.duration_s = 800.0;
  return experiment;
}

/// The tables of a run, none of which names the heredity.
template <class Rules>
std::vector<std::string> tables_of(const Experiment<Rules>& experiment) {
  const TemporaryFolder folder;
  run_part(experiment, backend::Kinematic::Params{}, folder.path() / "run", never, 1000.0);
  std::vector<std::string> tables;
  for (const char* name : {"events.csv", "agents.csv", "phylogeny.csv", "genomes.csv"}) {
    tables.push_back(content(folder.path() / "run" / name));
    REQUIRE(tables.back().size() > 1000);
  }
  return tables;
}

template <class Rules>
observe::RunDescription described(const Null& null) {
  return Ecology<Rules>{short_run<Rules>(null), backend::Kinematic::Params{}}.describe(100.0);
}

/// What a run says of its null.
std::string null_remark(const observe::RunDescription& run) {
  const auto found = std::ranges::find_if(run.remarks, [](const std::string& remark) { return remark.starts_with("null"); });
  return found == run.remarks.end() ? "" : *found;
}

/// The largest distance of the weights of newborns of a species from their parents'.
struct Distances {
  void on_event(const observe::Event& event, const View&) {
    if (event.kind != observe::EventKind::birth) return;
    const Individual& born = event.individual;
    const std::vector<double>& own = weights[born.id] = born.genome->weights;
    if (born.parents.empty()) return;
    double squares = 0.0;
    for (std::size_t i = 0; i < own.size(); ++i) squares += std::pow(own[i] - weights.at(born.parents.front())[i], 2);
    most[born.species] = std::max(most[born.species], std::sqrt(squares));
  }
  std::map<Species, double> most;
  std::map<IndividualId, std::vector<double>> weights;
};

}  // namespace

TEST_CASE_TEMPLATE("one-sided: a species -> the bytes of a table whose heredity is switched off for it", Table, Pond,
                   rules::Paper) {
  auto switched = short_run<BySide<Table>>();
  switched.rules.heredity.template get<prey>().inherited = false;
  const auto its = tables_of(switched);
  CHECK(tables_of(short_run<Table>(without_prey)) == its);
  CHECK(tables_of(short_run<Table>()) != its);
  CHECK(tables_of(short_run<Table>(Null::shadow)) != its);
}

TEST_CASE("one-sided: the only species that inherits -> the bytes of the shadow") {
  auto only_prey = short_run<BySide<Pond>>(without_prey);
  only_prey.rules.heredity.get<predator>().inherited = false;
  CHECK(tables_of(only_prey) == tables_of(under(Null::shadow, only_prey)));
}

TEST_CASE("one-sided: births -> genomes of that species as founders have them, of the other near their parents'") {
  for (const Species one : {prey, predator}) {
    Ecology<Pond> ecology{short_run<Pond>({Null::one_sided, predator_prey_web().name(one)}), backend::Kinematic::Params{}};
    Distances distances;
    ecology.run_until(800.0, distances);
    CHECK(distances.most[one] > 2.0);
    CHECK(distances.most[1 - one] > 0.0);
    CHECK(distances.most[1 - one] < 1.5);
  }
}

TEST_CASE("one-sided: description -> the heredity with its exception, a fingerprint of its own, and only parameters that act") {
  const auto prey_alone = described<Pond>(without_prey);
  CHECK(prey_alone.rules == "pond with heredity = own_copy, nothing_inherited for prey");
  const std::pair<std::string, std::string> heredity{"heredity", "own_copy, nothing_inherited for prey"};
  CHECK(std::ranges::count(prey_alone.slots, heredity) == 1);
  std::set<std::string> fingerprints;
  for (const Null& null : {Null{Null::none}, Null{Null::shadow}, without_prey, Null{Null::one_sided, "predator"}})
    fingerprints.insert(described<Pond>(null).fingerprint);
  CHECK(fingerprints.size() == 4);
  const auto has = [](const observe::RunDescription& run, std::string_view path) {
    return std::ranges::count(run.named_params, path, &NamedParam::path) == 1;
  };
  const auto by_side = described<BySide<Pond>>(without_prey);
  CHECK(has(by_side, "rules.heredity.predator.inherited"));
  CHECK_FALSE(has(by_side, "rules.heredity.prey.inherited"));
  CHECK(null_remark(by_side).empty());
}

TEST_CASE("one-sided: a species that inherits nothing anyway -> a remark that names the rule") {
  const auto remark = [](auto experiment) {
    return null_remark(Ecology{experiment, backend::Kinematic::Params{}}.describe(100.0));
  };
  const std::string begin = "null = one_sided_prey has no effect: prey already inherits nothing because of ";
  using Barren = with_heredity<Pond, reproduction::heredity::NothingInherited>;
  CHECK(remark(short_run<Barren>(without_prey)) == begin + "rules.heredity = nothing_inherited");
  auto switched = short_run<BySide<Pond>>(without_prey);
  switched.rules.heredity.get<prey>().inherited = false;
  CHECK(remark(switched) == begin + "rules.heredity: inherited = false");
  auto random = short_run<rules::Paper>(without_prey);
  random.rules.genome_source.random_share = 1.0;
  CHECK(remark(random) == begin + "rules.genome_source: random_share = 1");
  CHECK(remark(short_run<rules::Paper>(without_prey)).empty());
}

TEST_CASE("one-sided: a species that the table lacks, or its only one -> refused with the names") {
  CHECK(message_of<std::invalid_argument>([] {
          described<Pond>({Null::one_sided, "wolf"});
        }) == "null = one_sided_wolf: must be one_sided_prey or one_sided_predator, the table's species");
  CHECK(message_of<std::invalid_argument>([] {
          static_cast<void>(species_of(without_prey, FoodWeb{{"prey"}, {}}));
        }) == "null = one_sided_prey: must be in a table with at least two species; with one species it is the shadow");
}

TEST_CASE("null: its name -> the null, and back") {
  for (const Null& null : {Null{Null::none}, Null{Null::shadow}, Null{Null::neutral}, Null{Null::clones}, without_prey})
    CHECK(null_named(name_of(null)) == null);
  for (const char* name : {"", "one_sided", "one_sided_", "Shadow"}) CHECK(null_named(name) == std::nullopt);
}
