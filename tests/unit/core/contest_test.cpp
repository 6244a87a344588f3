// SPDX-License-Identifier: MIT
// Given individuals in an ecology without births and deaths, and plans of such contests.
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <support/temporary_folder.hpp>
#include <tools/contest/contest_plan.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/experiment/table_experiment.hpp>
#include <trophic/reproduction/traits/list.hpp>
#include <trophic/rules/paper.hpp>

using namespace trophic;
using test::message_of;
using test::predator;
using test::prey;

namespace {

using Weights = std::vector<double>;

struct Sight {
  static constexpr std::string_view name = "sight_m";
  static constexpr double first = 6.0, least = 1.0, most = 12.0, sd = 0.5;
};

/// Ten predators and ten prey with the weight of their number.
contest::Plan small_plan() {
  contest::Plan plan{.rule_table = "paper", .engine = "kinematic", .fingerprint = "", .duration_s = 200.0, .reach_m = 1.0};
  for (const Species species : {predator, prey}) {
    contest::Team team{.species = species};
    for (std::size_t i = 0; i < 10; ++i) team.genomes.push_back({.weights = Weights(15, 0.1 * static_cast<double>(i) - 0.4)});
    plan.teams.push_back(team);
  }
  plan.matches = {{.hunters = 0, .victims = 1, .places = 7}, {.hunters = 0, .victims = 1, .places = 8}};
  return plan;
}

struct Quiet {
  void on_event(const observe::Event& event, const View&) {
    CHECK((event.kind == observe::EventKind::birth || event.kind == observe::EventKind::tag_switch));
    births += event.kind == observe::EventKind::birth ? 1U : 0U;
  }
  std::size_t births = 0;
};

}  // namespace

TEST_CASE("contest: given individuals -> in their bodies, active, and no births, catches or deaths") {
  const contest::Plan plan = small_plan();
  const Lineup lineup = contest::lineup_of(plan, plan.matches[0]);
  const auto arena = TableExperiment<rules::Paper>{backend::Kinematic::Params{}}.contests()(7, lineup);
  Quiet quiet;
  arena->run_until(400.0, quiet);
  CHECK(quiet.births == 20);
  const View view = arena->view();
  REQUIRE(view.robots.size() == 20);
  for (BodyIndex body = 0; body < 20; ++body) {
    CHECK(view.robots[body].id == body);
    CHECK(view.robots[body].species == (body < 10 ? predator : prey));
    CHECK(view.robots[body].active);
    CHECK(view.robots[body].genome->weights == lineup[body].genome.weights);
  }
}

TEST_CASE("contest: table with traits -> individuals have those of their teams, and none or another number are refused") {
  using Rules = with_traits<rules::Paper, reproduction::traits::List<Sight>>;
  const auto make = TableExperiment<Rules>{backend::Kinematic::Params{}}.contests();
  contest::Plan plan = small_plan();
  for (contest::Team& team : plan.teams)
    for (Genome& genome : team.genomes) genome.traits = {5.0 + static_cast<double>(team.species)};
  const auto arena = make(7, contest::lineup_of(plan, plan.matches[0]));
  arena->run_until(2.0);
  for (const Individual& one : arena->view().robots) CHECK(one.genome->traits == Weights{5.0 + static_cast<double>(one.species)});
  for (const Weights& wrong : {Weights{}, Weights{1.0, 2.0}}) {
    plan.teams[1].genomes[3].traits = wrong;
    CHECK(message_of<std::invalid_argument>([&] { static_cast<void>(contest::play(make, plan, plan.matches[0])); }) ==
          "a contest of genomes with missing parts: must have the table's gaits, bodies and traits");
  }
}

TEST_CASE("contest: genomes of another size -> error that names both sizes") {
  contest::Plan plan = small_plan();
  plan.teams[0].genomes[3].weights.push_back(0.0);
  const auto make = TableExperiment<rules::Paper>{backend::Kinematic::Params{}}.contests();
  CHECK(message_of<std::invalid_argument>([&] { static_cast<void>(contest::play(make, plan, plan.matches[0])); }) ==
        "a contest of genomes of 16 weights: must have a genome of 15 weights, as the table's brain needs");
}

TEST_CASE("contest: same places -> same outcome, others -> another, reach of the arena -> contact at once") {
  contest::Plan plan = small_plan();
  const auto make = TableExperiment<rules::Paper>{backend::Kinematic::Params{}}.contests();
  const auto first = contest::play(make, plan, plan.matches[0]);
  CHECK(first.contact_s > 0.0);
  CHECK(first.contact_s <= 200.0);
  CHECK((first.contacted > 0.0 && first.contacted <= 1.0));
  CHECK(contest::play(make, plan, plan.matches[0]).contact_s == first.contact_s);
  CHECK(contest::play(make, plan, plan.matches[1]).contact_s != first.contact_s);
  plan.reach_m = 100.0;
  const auto near = contest::play(make, plan, plan.matches[0]);
  CHECK((near.contact_s == 0.0 && near.contacted == 1.0));
  plan.reach_m = 1e-9;
  const auto far = contest::play(make, plan, plan.matches[0]);
  CHECK((far.contact_s == 200.0 && far.contacted == 0.0));
}

TEST_CASE("contest: plan -> the teams and matches of its file, errors name the file") {
  const test::TemporaryFolder folder;
  const std::string text =
      R"({"format":"trophic contests","version":1,"rule_table":"paper","engine":"kinematic","fingerprint":"f","params":{},)"
      R"("duration_s":200.0,"reach_m":1.0,"teams":[{"species":0,"genomes":[[[0.30000000000000004],[],[],[]]]},)"
      R"({"species":1,"genomes":[[[0.1],[0.3333333333333333],[2.0,-1e-300],[0.1,7.0]]]}],"matches":[[0,1,281474976710655]]})";
  const contest::Plan plan = contest::read_plan(folder.file("plan.json", text));
  CHECK((plan.rule_table == "paper" && plan.engine == "kinematic" && plan.fingerprint == "f"));
  CHECK((plan.duration_s == 200.0 && plan.reach_m == 1.0));
  REQUIRE((plan.teams.size() == 2 && plan.matches.size() == 1));
  CHECK(plan.teams[0].genomes[0].weights == Weights{0.1 + 0.2});
  const Genome& genome = plan.teams[1].genomes[0];
  CHECK((plan.teams[1].species == 1 && genome.gait_genes == Weights{1.0 / 3.0}));
  CHECK((genome.body_genes == Weights{2.0, -1e-300} && genome.traits == Weights{0.1, 7.0}));
  CHECK((plan.matches[0].hunters == 0 && plan.matches[0].victims == 1));
  CHECK(plan.matches[0].places == (std::uint64_t{1} << 48U) - 1);
  CHECK(contest::text_of({{.contact_s = 0.1, .contacted = 0.25}}) == "[[0.1,0.25]]\n");

  for (const auto& [what, by, says] :
       {std::tuple{"\"version\":1", "\"version\":2", "version = 2: must be 1, which this program writes"},
        std::tuple{"[[0,1,", "[[2,1,", "matches: a team does not exist"}, std::tuple{"trophic contests", "", "is not a plan"},
        std::tuple{"\"reach_m\":1.0", "\"reach_m\":0.0", "reach_m: must be > 0"}, std::tuple{"{\"format\"", "[", ""}}) {
    std::string wrong = text;
    const std::string path = folder.file("wrong.json", wrong.replace(wrong.find(what), std::string_view{what}.size(), by));
    const std::string message = message_of<std::invalid_argument>([&] { static_cast<void>(contest::read_plan(path)); });
    CHECK(message.starts_with(path + ": " + says));
  }
}
