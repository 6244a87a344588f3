// SPDX-License-Identifier: MIT
// The rules of docs/how-to/a-living-world.md in runs.
#include <doctest/doctest.h>

#include <a-living-world/01_part.cpp>
#include <a-living-world/02_part.cpp>
#include <a-living-world/03_part.cpp>
#include <a-living-world/04_part.cpp>
#include <map>
#include <regex>
#include <sstream>
#include <support/energy_auditor.hpp>
#include <support/temporary_folder.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/worlds/pond.hpp>
#include <unit/checkpoint/resumed.hpp>

using namespace trophic::test;
using worlds::Pond;

namespace {

using ManuredPond = with_resource<Pond, Manure>;
using MatingPond = WithSexes<Pond>;
using SeeingPond = with_traits<with_visibility<Pond, AsFarAsItSees>, Traits>;

template <class Rules>
[[nodiscard]] Experiment<Rules> short_run() {
  Experiment<Rules> experiment{.seed = 4};
  experiment.ecology.duration_s = 800.0;
  experiment.rules.recruitment.spare_bodies = 90;
  experiment.rules.recruitment.birth_J = 60.0;
  return experiment;
}

/// Individuals with two ancestors in a phylogeny. Holds it against the ALife data standard: ids that are there once, an
/// ancestor_list of ids that are there and older or [none], and an end after the beginning.
[[nodiscard]] std::size_t couples_in(const std::string& phylogeny) {
  std::istringstream lines{phylogeny};
  std::string line;
  std::getline(lines, line);
  CHECK(line.starts_with("id,ancestor_list,origin_time,destruction_time,"));  // with two parents no ancestor_id
  const std::regex row{R"(^(\d+),"?\[(none|\d+(?:,\d+)*)\]"?,([^,]+),([^,]+),)"};
  std::map<std::string, double> origins_s;
  std::vector<std::pair<std::string, std::string>> descents;
  std::size_t couples = 0;
  while (std::getline(lines, line)) {
    std::smatch cells;
    REQUIRE(std::regex_search(line, cells, row));
    CHECK(origins_s.emplace(cells[1], std::stod(cells[3])).second);
    CHECK((cells[4] == "inf" || std::stod(cells[4]) >= std::stod(cells[3])));
    std::istringstream ancestors{cells[2] == "none" ? "" : cells[2].str()};
    std::size_t count = 0;
    for (std::string ancestor; std::getline(ancestors, ancestor, ','); ++count) descents.emplace_back(cells[1], ancestor);
    couples += count == 2 ? 1U : 0U;
  }
  for (const auto& [child, ancestor] : descents) {
    REQUIRE(origins_s.contains(ancestor));
    CHECK(origins_s[ancestor] < origins_s[child]);
  }
  return couples;
}

}  // namespace

TEST_CASE_TEMPLATE("rules of the how-to: run killed three times -> the same bytes, a ledger that closes", Rules, ManuredPond,
                   Orchard, MatingPond, SeeingPond) {
  const TemporaryFolder folder;
  const auto experiment = short_run<Rules>();
  const io::OutputOptions output{.replay_hz = 0.0, .states = true};
  for (const auto& [name, ticks] : {std::pair{"whole", std::vector{never}}, {"cut", {60, 170, 301, never}}})
    for (const std::int64_t tick : ticks)
      run_part(experiment, backend::Kinematic::Params{}, folder.path() / name, tick, 100.0, output);
  CHECK(results_in(folder.path() / "whole") == results_in(folder.path() / "cut"));
  for (const char* table : {"energy.csv", "resource.csv", "field.csv"}) {
    CHECK(content(folder.path() / "whole" / table).size() > 500);
    CHECK(content(folder.path() / "whole" / table) == content(folder.path() / "cut" / table));
  }
  Ecology<Rules> ecology{experiment, backend::Kinematic::Params{}};
  EnergyAuditor auditor;
  ecology.run_until(800.0, auditor);
  CHECK(auditor.worst < 1e-9);
  CHECK(auditor.turned_over_J > 100.0);
}

TEST_CASE(
    "two parents of a pond: a mother and a father near, both in the phylogeny, the distance of mutation alone, one or both pay") {
  struct Couples {
    void on_event(const observe::Event& event, const View& view) {
      const Individual& child = event.individual;
      if (event.kind != observe::EventKind::birth) return;
      is_female[child.id] = view.trait<reproduction::traits::Sex>(event.body) == 1.0;
      if (child.parents.size() != 2) return;
      CHECK(is_female.at(child.parents[0]));
      CHECK_FALSE(is_female.at(child.parents[1]));
      CHECK(child.mutation_distance > 0.0);
      CHECK(child.mutation_distance < 8.0 * 0.05 * std::sqrt(15.0));  // by eight standard deviations of each weight
      const auto energy_of = [&](IndividualId id) { return std::ranges::find(view.robots, id, &Individual::id)->energy_J; };
      CHECK(child.energy_J >= (both_pay ? 2.0 : 1.0) * 0.3 * 60.0);
      if (!both_pay) CHECK(child.energy_J == doctest::Approx(0.3 / 0.7 * energy_of(child.parents[0])));
      ++couples;
    }
    bool both_pay;
    std::map<IndividualId, bool> is_female = {};
    std::size_t couples = 0;
  };
  for (const bool both_pay : {true, false}) {
    CAPTURE(both_pay);
    auto experiment = short_run<MatingPond>();
    experiment.rules.recruitment.both_pay = both_pay;
    Ecology<MatingPond> ecology{experiment, backend::Kinematic::Params{}};
    Couples couples{both_pay};
    ecology.run_until(800.0, couples);
    CHECK(couples.couples > 10);
  }

  const TemporaryFolder folder;
  run_part(short_run<MatingPond>(), backend::Kinematic::Params{}, folder.path() / "run", never, 100.0, {.replay_hz = 0.0});
  CHECK(couples_in(content(folder.path() / "run" / "phylogeny.csv")) > 10);
}
