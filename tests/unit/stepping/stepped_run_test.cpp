// SPDX-License-Identifier: MIT
// Decisions from outside: the same bytes from the same decisions, other decisions, wrong ones, and a run that is left.
#include <doctest/doctest.h>

#include <cstdlib>
#include <limits>
#include <numbers>
#include <support/odometer.hpp>
#include <tools/tables/shipped_tables.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/backend/torus.hpp>
#include <trophic/control/brain/hebbian.hpp>
#include <trophic/control/brain/outside.hpp>
#include <trophic/control/brain/recurrent_brain.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/perception/sensors/per_species.hpp>
#include <trophic/perception/sensors/random_turn.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/with.hpp>
#include <unit/stepping/stepped.hpp>

using namespace trophic;
using namespace trophic::test;
namespace sensors = perception::sensors;

namespace {

/// The compiled tables name no folder of the sources.
const bool has_models = ::setenv("TROPHIC_MODELS", TROPHIC_MODEL_DIR, 0) == 0;

/// Sees whom it sees by chance.
struct Mist {
  static constexpr std::string_view name = "mist";
  [[nodiscard]] bool perceives(BodyIndex, BodyIndex other, const View& view, Rng& rng) const {
    return view.robots[other].active && rng.chance(0.5);
  }
};

/// Rules that draw, rules with a State, other inputs for each species, and a brain that learns.
using Misty = with_brain<with_sensors<with_visibility<rules::Paper, Mist>,
                                      sensors::PerSpecies<sensors::List<sensors::SideOfAdversary, Odometer, sensors::RandomTurn>,
                                                          sensors::List<sensors::RandomTurn>>>,
                         control::brain::Hebbian<control::brain::RecurrentBrain>>;
using Outside = with_brain<rules::Paper, control::brain::Outside>;

template <class Rules>
[[nodiscard]] Ecology<Rules> ecology_of(std::uint64_t seed = 7) {
  return Ecology<Rules>{{.seed = seed}, backend::Kinematic::Params{}};
}

/// Notes what observers are told of a run's end, and all tags.
struct Told {
  std::string rules;
  std::string brain;
  bool has_ended = false;
  std::string failure;
  std::vector<int> tags;
  void on_start(const observe::RunDescription& run, const View&) {
    rules = run.rules;
    for (const auto& [slot, policy] : run.slots)
      if (slot == "brain") brain = policy;
  }
  void on_tick(const View& view) {
    tags.clear();
    for (const Individual& one : view.robots) tags.push_back(one.tag);
  }
  void on_end(const View&) { has_ended = true; }
  void on_failure(std::string_view what) { failure = what; }
};

[[nodiscard]] std::vector<double> all_of(const Perceived& now, double turn, double tag) {
  std::vector<double> outputs;
  for (std::size_t i = 0; i < now.bodies.size(); ++i) outputs.insert(outputs.end(), {turn, tag});
  return outputs;
}

/// The sentence of what `step` throws.
template <class Error>
[[nodiscard]] std::string refusal(const auto& step) {
  try {
    step();
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing was thrown";
}

}  // namespace

TEST_CASE("stepped run: every shipped table, decided by its own brains -> the bytes of the ordinary run") {
  REQUIRE(has_models);
  const auto tables = command::shipped_tables();
  CHECK(tables.size() >= 9);
  const std::array backends{BackendChoice{backend::Kinematic::Params{}}, BackendChoice{backend::Torus::Params{}}};
  for (const auto& [name, make] : tables) {
    CAPTURE(name);
    const auto own = make(backends.front())->backends();
    const BackendChoice& backend = backends[own.empty() || own.front() == "kinematic" ? 0 : 1];
    for (const DecisionOrder order : {DecisionOrder::together, DecisionOrder::in_turn}) {
      CAPTURE(order);
      const auto experiment = make(backend);
      experiment->ecology().decision_order = order;
      const double until_s = 100.0 * experiment->ecology().tick_s;
      const std::size_t stops = check_same_bytes([&] { return experiment->simulations(Null::none)(3); }, until_s);
      CHECK(stops >= 50);
      if (order == DecisionOrder::in_turn) CHECK(stops >= 500);  // one robot at a time
      if (order == DecisionOrder::together) CHECK(stops <= 101);
    }
  }
}

TEST_CASE("stepped run: rules that draw and keep states, a brain that learns -> the bytes of the ordinary run") {
  for (const DecisionOrder order : {DecisionOrder::together, DecisionOrder::in_turn}) {
    Experiment<Misty> experiment{.seed = 5};
    experiment.ecology.decision_order = order;
    check_same_bytes([&] { return std::make_unique<Ecology<Misty>>(experiment, backend::Kinematic::Params{}); }, 600.0);
  }
}

TEST_CASE("stepped run: own outputs asked for twice -> a brain that learns is asked once") {
  auto ecology = ecology_of<Misty>();
  SteppedRun run{ecology, 100.0};
  REQUIRE(run.sense());
  const std::vector<double> first(run.own_outputs().begin(), run.own_outputs().end());
  const auto again = run.own_outputs();
  CHECK(std::ranges::equal(first, again));
}

TEST_CASE("stepped run: decisions of another program -> robots follow them, the description says so") {
  auto ecology = ecology_of<rules::Paper>();
  Told told;
  SteppedRun run{ecology, 200.0, told};
  while (run.sense()) {
    run.decide(all_of(run.perceived(), 1.0, -1.0));
    for (const Individual& one : ecology.view().robots) CHECK(one.target_angle_rad == 0.7);
  }
  CHECK(told.has_ended);
  CHECK(told.rules == "paper with brain = outside");
  CHECK(told.brain == "outside");
  CHECK(std::ranges::count(told.tags, -1) == std::ssize(told.tags));
  CHECK(ecology.describe(200.0).rules == "paper");
  CHECK(ecology.describe(200.0).fingerprint != ecology.stepping().describe_outside(200.0).fingerprint);
}

TEST_CASE("stepped run: table with the brain Outside -> genes are inherited, acts are the outputs, no ordinary run") {
  Experiment<Outside> experiment{.seed = 2};
  experiment.rules.brain.genes = 4;
  Ecology<Outside> ecology{experiment, backend::Kinematic::Params{}};
  CHECK(refusal<std::invalid_argument>([&] { ecology.run_until(10.0); }).find("rules.brain = outside: ") == 0);
  Told told;
  SteppedRun run{ecology, 600.0, told};
  while (run.sense()) {
    const Perceived& now = run.perceived();
    std::vector<double> outputs;
    for (const BodyIndex body : now.bodies) {
      const std::vector<double>& genes = ecology.view().robots[body].genome->weights;
      REQUIRE(genes.size() == 4);
      outputs.insert(outputs.end(), {genes[0], genes[1]});
    }
    run.decide(outputs);
    for (const Individual& one : ecology.view().robots) CHECK(one.target_angle_rad == one.genome->weights[0]);
  }
  CHECK(told.rules == "paper with brain = outside");
  bool any_mutated = false;
  for (const Individual& one : ecology.view().robots) any_mutated = any_mutated || one.mutation_distance > 0.0;
  CHECK(any_mutated);
}

TEST_CASE("stepped run: wrong outputs -> one sentence, and the robots still wait") {
  auto ecology = ecology_of<rules::Paper>();
  Told told;
  SteppedRun run{ecology, 20.0, told};
  CHECK(refusal<std::logic_error>([&] { run.decide(std::vector<double>{}); }).find("decide: no robot waits") == 0);
  REQUIRE(run.sense());
  CHECK(refusal<std::logic_error>([&] { static_cast<void>(run.sense()); }) == "sense: the robots wait for decide(outputs)");
  CHECK(refusal<std::invalid_argument>([&] { run.decide(std::vector<double>(59)); }) ==
        "outputs: 59 numbers: must be 60, 2 for each of 30 robots");
  std::vector<double> outputs = all_of(run.perceived(), 1.0, 1.0);
  outputs[5] = std::numeric_limits<double>::quiet_NaN();
  CHECK(refusal<std::invalid_argument>([&] { run.decide(outputs); }) ==
        "outputs: row 2, individual 2 (prey): tag = nan: must be finite");
  CHECK(refusal<std::logic_error>([&] {
          Archive archive;
          ecology.persist(archive);
        }) == "the robots of tick 0 wait for decide(outputs)");
  CHECK(run.waits());
  run.decide(all_of(run.perceived(), 1.0, 1.0));
  while (run.sense()) run.decide(run.own_outputs());
  CHECK(told.has_ended);
  CHECK(told.failure.empty());
}

TEST_CASE("stepped run: left in the middle of a tick -> no end for observers, no other run until it is decided") {
  auto ecology = ecology_of<rules::Paper>();
  Told told;
  {
    SteppedRun run{ecology, 100.0, told};
    for (int tick = 0; tick < 3 && run.sense(); ++tick) run.decide(run.own_outputs());
    REQUIRE(run.sense());
  }
  CHECK_FALSE(told.has_ended);
  CHECK(refusal<std::logic_error>([&] { ecology.run_until(100.0); }) == "the robots of tick 3 wait for decide(outputs)");
  CHECK_THROWS_AS((SteppedRun{ecology, 100.0}), std::logic_error);
}

TEST_CASE("stepped run: stopped between ticks -> run_until continues to the bytes of one run") {
  auto ecology = ecology_of<rules::Paper>();
  Told told;
  SteppedRun run{ecology, 1000.0, told};
  for (int tick = 0; tick < 25; ++tick) {
    REQUIRE(run.sense());
    CHECK(refusal<std::logic_error>([&] { run.stop(); }) == "stop: the robots wait for decide(outputs)");
    run.decide(run.own_outputs());
  }
  run.stop();
  CHECK(told.has_ended);
  CHECK_FALSE(run.sense());
  ecology.run_until(100.0);
  auto whole = ecology_of<rules::Paper>();
  whole.run_until(100.0);
  Archive there;
  Archive here;
  whole.persist(there);
  ecology.persist(here);
  const bool same = there.bytes() == here.bytes();
  CHECK(same);
}

TEST_CASE("stepped run: spaces -> names, units and bounds of inputs and outputs, by species") {
  auto paper = ecology_of<rules::Paper>();
  const Spaces spaces = paper.stepping().spaces();
  REQUIRE(spaces.inputs.size() == 2);
  REQUIRE(spaces.inputs[0].size() == 3);
  CHECK(spaces.inputs[0][0].name == "side_of_adversary");
  CHECK(spaces.inputs[0][1].least == 0.0);
  CHECK(spaces.inputs[1][2].most == 0.5);
  REQUIRE(spaces.outputs.size() == 2);
  CHECK(spaces.outputs[0].name == "turn");
  CHECK(spaces.outputs[0].most == 1.0);  // its sign turns
  auto outside = ecology_of<Outside>();
  CHECK(outside.stepping().spaces().outputs[0].unit == "rad");
  CHECK(outside.stepping().spaces().outputs[0].least == -std::numbers::pi);
  auto misty = ecology_of<Misty>();
  CHECK(misty.stepping().spaces().inputs[0].size() == 3);
  CHECK(misty.stepping().spaces().inputs[1].size() == 1);
  CHECK(misty.stepping().spaces().inputs[0][1].most == std::numeric_limits<double>::infinity());  // an odometer
}
