// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <tools/command/read_parameters.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/death/starvation/exemption/no_exemption.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/initialization/community/food_chain.hpp>
#include <trophic/perception/visibility/within_range.hpp>
#include <trophic/reproduction/parent/most_escapes.hpp>
#include <trophic/rules/by_species.hpp>
#include <trophic/rules/paper.hpp>

using namespace trophic;
using initialization::community::PredatorPrey;
using rules::by_species;

TEST_CASE("by species: numbers -> one set per species, under its name") {
  using Rules = with_mutation<rules::Paper, by_species<reproduction::mutation::NormalMutation>>;
  CHECK(table_name<Rules>() == "paper with mutation = normal_mutation_by_species");
  Ecology<Rules>::Params params{.seed = 8};
  command::read_parameters(params, command::read_assignment("rules.mutation.prey.sd=0.5"));
  command::read_parameters(params, command::read_assignment("rules.mutation.predator.sd=0"));
  std::vector<std::string> paths;
  for (const NamedParam& param : named_params_of(params.rules.mutation)) paths.push_back(param.path);
  CHECK(paths == std::vector<std::string>{"prey.sd", "predator.sd"});

  struct Births {
    void on_event(const observe::Event& event, const View&) {
      if (event.kind != observe::EventKind::birth || !event.individual.parent()) return;
      const bool is_prey = event.individual.species == PredatorPrey::prey;
      CHECK((event.individual.mutation_distance > 0.0) == is_prey);
      ++(is_prey ? prey : predators);
    }
    std::size_t prey = 0;
    std::size_t predators = 0;
  } births;
  Ecology<Rules> ecology{params, backend::Kinematic::Params{}};
  ecology.run_until(2000.0, births);
  CHECK(births.prey > 5);
  CHECK(births.predators > 5);
}

TEST_CASE("by species: perception, death and floor -> numbers of the species concerned") {
  const test::HandPopulation robots{{{.species = test::prey}, {.species = test::predator, .x_m = 4.0}}};
  Rng rng{1, Stream::user};
  const NoState none;
  using Range = by_species<perception::visibility::WithinRange, PredatorPrey>;
  Range::Params ranges;
  ranges.get<PredatorPrey::prey>().range_m = 3.0;
  const Range range{ranges};
  CHECK_FALSE(perception::ask::perceives(range, none, 0, 1, robots.view(), rng));
  CHECK(perception::ask::perceives(range, none, 1, 0, robots.view(), rng));
  CHECK(perception::ask::horizon(range, robots.individuals[0]).within_m == 3.0);
  CHECK(perception::ask::horizon(range, robots.individuals[1]).within_m == 5.0);

  using Floor = by_species<death::floor::VictimFloor, PredatorPrey>;
  Floor::Params floors;
  floors.get<PredatorPrey::prey>().floor = 0;
  CHECK(death::ask::may_die(Floor{floors}, PredatorPrey::prey, robots.view()));
  CHECK_FALSE(death::ask::may_die(Floor{floors}, PredatorPrey::predator, robots.view()));
}

TEST_CASE("by species: reach of catches -> each hunter's own, by distance, and a victim of two falls to the closest") {
  using death::Capture;
  using Reach = by_species<death::capture::CatchWithinReach, initialization::community::FoodChain>;
  const test::HandPopulation robots{{{.species = 0}, {.species = 1, .x_m = 0.9}, {.species = 2, .x_m = -0.5}},
                                    FoodWeb{{"grazer", "hunter", "apex"}, {{1, 0}, {2, 0}, {2, 1}}}};
  const auto captures = [&](double hunter_m, double apex_m) {
    Reach::Params reach;
    reach.get<1>().reach_m = hunter_m;
    reach.get<2>().reach_m = apex_m;
    Rng rng{1, Stream::captures};
    return death::ask::captures(Reach{reach}, std::span<const NoState>{}, robots.view(), rng);
  };
  CHECK(captures(0.8, 0.4).empty());
  CHECK(captures(1.0, 0.4) == std::vector<Capture>{{1, 0}});
  CHECK(captures(1.0, 0.6) == std::vector<Capture>{{2, 0}});
  CHECK(captures(0.8, 2.0) == std::vector<Capture>{{2, 0}, {2, 1}});
}

/// Shoes wear out by walking.
struct Shoes {
  static constexpr std::string_view name = "shoes";
  struct Params {
    double sole_mm = 1.0;
    double wear_mm_m = 1.0;
    static constexpr auto fields() {
      return std::tuple{field("sole_mm", &Params::sole_mm), field("wear_mm_m", &Params::wear_mm_m)};
    }
  };
  Params params;
  struct State {
    double sole_mm = 0.0;
    static constexpr auto fields() { return std::tuple{field("sole_mm", &State::sole_mm)}; }
  };
  [[nodiscard]] State born(const Individual&, const State*, const State&) const { return {params.sole_mm}; }
  void on_walk(State& own, BodyIndex, double distance_m, const View&) const { own.sole_mm -= params.wear_mm_m * distance_m; }
  [[nodiscard]] bool dies(const Individual&, const View&, Rng&, const State&) const { return false; }
};

TEST_CASE("by species: rule with a state -> state per body, numbers of its species") {
  using Store = by_species<Shoes, PredatorPrey>;
  Store::Params numbers;
  numbers.get<PredatorPrey::prey>() = {.sole_mm = 7.0, .wear_mm_m = 1.0};
  numbers.get<PredatorPrey::predator>() = {.sole_mm = 9.0, .wear_mm_m = 2.0};
  const Store store{numbers};
  const test::HandPopulation robots{{{.species = test::prey}, {.species = test::predator}}};
  auto prey = store.of(test::prey).born(robots.individuals[0], nullptr, {});
  auto predator = store.of(test::predator).born(robots.individuals[1], nullptr, {});
  store.of(test::prey).on_walk(prey, 0, 1.0, robots.view());
  store.of(test::predator).on_walk(predator, 1, 1.0, robots.view());
  CHECK(prey.sole_mm == 6.0);
  CHECK(predator.sole_mm == 7.0);

  using Rules = with_senescence<rules::Paper, by_species<Shoes>>;
  Ecology<Rules>::Params params;
  params.rules.senescence = numbers;
  const Ecology<Rules> ecology{params, backend::Kinematic::Params{}};
  CHECK(ecology.states().senescence[0].sole_mm == 7.0);
  CHECK(ecology.states().senescence[29].sole_mm == 9.0);
}

TEST_CASE("by species: every suitable slot with equal numbers -> same run") {
  using Rules = with_parent_after<
      with_mutation<
          with_activation<with_tag_switch<with_floor<with_visibility<rules::Paper, by_species<perception::visibility::SameTag>>,
                                                     by_species<death::floor::VictimFloor>>,
                                          by_species<perception::tag_switch::TagCoolDown>>,
                          by_species<death::activation::ActiveAwayFromHunters>>,
          by_species<reproduction::mutation::NormalMutation>>,
      Cause::starved, by_species<reproduction::parent::NearestActiveVictim>>;
  Ecology<Rules> by_kind{{.seed = 8}, backend::Kinematic::Params{}};
  Ecology<rules::Paper> plain{{.seed = 8}, backend::Kinematic::Params{}};
  by_kind.run_until(500.0);
  plain.run_until(500.0);
  for (BodyIndex body = 0; body < 30; ++body) {
    CHECK(by_kind.view().robots[body].id == plain.view().robots[body].id);
    CHECK(by_kind.view().robots[body].tag == plain.view().robots[body].tag);
    CHECK(by_kind.view().poses[body].x_m == plain.view().poses[body].x_m);
  }
}

TEST_CASE("by species: another community -> numbers for its species") {
  using Chain = with_mutation<with_community<rules::Paper, initialization::community::FoodChain>,
                              by_species<reproduction::mutation::NormalMutation>>;
  std::vector<std::string> paths;
  for (const NamedParam& param : named_params_of(RuleParams<Chain>{}.mutation)) paths.push_back(param.path);
  CHECK(paths == std::vector<std::string>{"grazer.sd", "hunter.sd", "apex.sd"});
  using Swapped = with_community<with_mutation<rules::Paper, by_species<reproduction::mutation::NormalMutation>>,
                                 initialization::community::FoodChain>;
  CHECK(named_params_of(RuleParams<Swapped>{}.mutation).size() == 3);
}

TEST_CASE("by species: rule with a State as a part -> numbers of the dying individual's species") {
  using Rules = with_parent_after<rules::Paper, Cause::starved, by_species<reproduction::parent::MostEscapes>>;
  static_assert(is_rule_table<Rules>);
  static_assert(
      is_rule_table<with_starvation_exemption<rules::Paper, by_species<death::starvation::exemption::NearPerceivedVictim>>>);
  RuleParams<Rules> numbers;
  numbers.parent.starved.get<PredatorPrey::predator>().near_m = 2.0;
  const auto policies = make_policies<Rules>(numbers);
  const auto& starved = policies.parent.part<static_cast<std::size_t>(Cause::starved)>();
  CHECK(starved.of(PredatorPrey::predator).params.near_m == 2.0);
  CHECK(starved.of(PredatorPrey::prey).params.near_m == 3.0);
}

TEST_CASE("by species: sweep of an interval between starvation procedures by its name -> this species starves less often") {
  using Chain = with_community<rules::Paper, initialization::community::FoodChain>;
  using Interval = by_species<death::starvation::interval::DelayedCrowdingInterval>;
  using Rules = with_starvation_exemption<with_starvation_interval<Chain, Interval>, death::starvation::exemption::NoExemption>;
  struct Starved {
    void on_event(const observe::Event& event, const View&) {
      if (event.kind == observe::EventKind::death && event.cause == Cause::starved) ++by.at(event.individual.species);
    }
    std::array<int, 3> by{};
  };
  int before = 1000;
  for (const std::string base_ticks : {"12", "40", "1000"}) {
    Ecology<Rules>::Params params{.seed = 8};
    command::read_parameters(params, command::read_assignment("rules.starvation.interval.hunter.base_ticks=1000"));
    command::read_parameters(params, command::read_assignment("rules.starvation.interval.apex.base_ticks=" + base_ticks));
    Ecology<Rules> ecology{params, backend::Kinematic::Params{}};
    Starved starved;
    ecology.run_until(400.0, starved);
    CHECK(starved.by[0] == 0);
    CHECK(starved.by[1] == 0);
    CHECK(starved.by[2] < before);
    before = starved.by[2];
  }
  CHECK(before == 0);
}
