// SPDX-License-Identifier: MIT
// Species with sensors, brains and reaches of their own.
#include <doctest/doctest.h>

#include <sstream>
#include <support/hand_population.hpp>
#include <support/odometer.hpp>
#include <support/temporary_folder.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/control/brain/feed_forward_brain.hpp>
#include <trophic/perception/sensors/per_species.hpp>
#include <trophic/rules/paper.hpp>
#include <unit/checkpoint/resumed.hpp>

using namespace trophic;
namespace sensors = perception::sensors;

namespace {

using PreyList = sensors::List<sensors::SideOfAdversary, test::Odometer, sensors::TagRatioOfAll, sensors::DistanceOverTerrain>;
using PredatorList = sensors::List<sensors::DistanceOverTerrain>;
using Sensing = with_sensors<rules::Paper, sensors::PerSpecies<PreyList, PredatorList>>;
using Thinking = with_brain<Sensing, rules::by_species<control::brain::FeedForwardBrain>>;
using Differ = with_capture<Thinking, rules::by_species<death::capture::CatchWithinReach>>;

Experiment<Differ> experiment() {
  Experiment<Differ> own{.seed = 4};
  own.ecology.duration_s = 600.0;
  own.rules.brain.get<0>().hidden = 2;
  own.rules.brain.get<1>().hidden = 5;
  own.rules.brain.get<1>().turn_angle_rad = 0.3;
  own.rules.capture.get<1>().reach_m = 1.5;
  return own;
}

struct Three {
  static constexpr std::array<std::string_view, 3> species_names{"prey", "fox", "owl"};
};

struct WatchesSpecies {
  bool wants_decisions() { return true; }
  void on_decision(const observe::DecisionRecord& one, const View& view) {
    const Individual& self = view.robots[one.body];
    const bool is_prey = self.species == 0;
    REQUIRE(one.inputs.size() == std::size_t{is_prey ? 4U : 1U});
    CHECK(self.genome->weights.size() == std::size_t{is_prey ? 12U : 15U});
    CHECK(std::abs(one.target_angle_rad) == (is_prey ? 0.7 : 0.3));
    if (is_prey) walked_m = std::max(walked_m, one.inputs[1]);
    ++decisions;
  }
  void on_event(const observe::Event& event, const View& view) {
    births += event.kind == observe::EventKind::birth && !event.individual.parents.empty() ? 1U : 0U;
    if (event.kind != observe::EventKind::capture) return;
    CHECK(view.distance_m(event.body, *view.robots[event.body].adversary) >= 0.0);
    ++catches;
  }
  double walked_m = 0.0;
  std::size_t decisions = 0;
  std::size_t births = 0;
  std::size_t catches = 0;
};

}  // namespace

TEST_CASE("per species: lists of sensors, neurons and reach by species -> genomes, inputs and catches of each") {
  std::vector<std::string> paths;
  for (const NamedParam& param : named_params_of(experiment().rules.capture)) paths.push_back(param.path);
  CHECK(paths == std::vector<std::string>{"prey.reach_m", "prey.min_age_s", "predator.reach_m", "predator.min_age_s"});
  Ecology<Differ> ecology{experiment(), backend::Kinematic::Params{}};
  CHECK(ecology.describe(1.0).inputs == std::vector<std::string>{"side_of_adversary / distance_over_terrain", "odometer / -",
                                                                 "tag_ratio_of_all / -", "distance_over_terrain / -"});
  WatchesSpecies watch;
  ecology.run_until(600.0, watch);
  CHECK(watch.decisions > 3000);
  CHECK(watch.births > 10);
  CHECK(watch.catches > 10);
  CHECK(watch.walked_m > 1.0);
}

TEST_CASE("per species: interrupted run -> same bytes, senses with empty cells beyond a species' inputs") {
  const test::TemporaryFolder folder;
  const auto ignored = [](std::size_t, auto&) {};
  test::check_resumed(experiment(), backend::Kinematic::Params{}, folder.path(), {100, 250}, 200.0, ignored);
  Ecology<Differ> ecology{experiment(), backend::Kinematic::Params{}};
  io::RunFolder files{folder.path() / "senses", {}, {.senses = true}};
  ecology.run_until(20.0, files);
  const std::string senses = test::content(folder.path() / "senses" / "senses.csv");
  CHECK(senses.find("input3\n") != std::string::npos);
  CHECK(senses.find("input4") == std::string::npos);
  std::size_t predators = 0;
  std::istringstream rows{senses};
  for (std::string row; std::getline(rows, row);) {
    const bool is_predator = row.find(",predator,") != std::string::npos;
    CHECK(row.ends_with(",,,") == is_predator);
    predators += is_predator ? 1 : 0;
  }
  CHECK(predators > 100);
  std::istringstream births{test::content(folder.path() / "senses" / "genomes.csv")};
  for (std::string row; std::getline(births, row);) CHECK(std::ranges::count(row, ',') == 17);  // 15 weights behind three cells
}

TEST_CASE("per species: a victim in reach of two species -> the closer hunter's, each by its own reach") {
  const FoodWeb web{{"prey", "fox", "owl"}, {{.hunter = 1, .victim = 0}, {.hunter = 2, .victim = 0}}};
  const test::HandPopulation robots{{{.species = 0},
                                     {.species = 1, .x_m = 0.9},
                                     {.species = 2, .x_m = -0.5},
                                     {.species = 0, .x_m = 5.0},
                                     {.species = 1, .x_m = 6.0},
                                     {.species = 2, .x_m = 4.2}},
                                    web};
  rules::by_species<death::capture::CatchWithinReach, Three>::Params params;
  params.get<1>().reach_m = 1.0;
  params.get<2>().reach_m = 0.6;
  const rules::by_species<death::capture::CatchWithinReach, Three> rule{params};
  Rng rng{1, Stream::user};
  CHECK(death::ask::captures(rule, {}, robots.view(), rng) == std::vector<death::Capture>{{2, 0}, {4, 3}});
}

TEST_CASE("per species: lists without states -> brains of other sizes") {
  using Lists = sensors::PerSpecies<sensors::List<sensors::SideOfAdversary>,
                                    sensors::List<sensors::DistanceOverTerrain, sensors::TagRatioOfAll>>;
  Ecology<with_sensors<rules::Paper, Lists>> ecology{{}, backend::Kinematic::Params{}};
  ecology.run_until(100.0);
  for (const Individual& one : ecology.view().robots) CHECK(one.genome->weights.size() == (one.species == 0 ? 9 : 12));
}
