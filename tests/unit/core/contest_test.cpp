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
#include <trophic/support/new_file.hpp>

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
          "a contest of genomes without some parts: must have the table's gaits, bodies and traits");
  }
}

TEST_CASE("contest: genomes of another size -> error that names both sizes") {
  contest::Plan plan = small_plan();
  plan.teams[0].genomes[3].weights.push_back(0.0);
  const auto make = TableExperiment<rules::Paper>{backend::Kinematic::Params{}}.contests();
  CHECK(message_of<std::invalid_argument>([&] { static_cast<void>(contest::play(make, plan, plan.matches[0])); }) ==
        "a contest of genomes of 16 weights: must have a genome of 15 weights, as the table's brain takes it");
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

TEST_CASE("contest: plan and outcomes -> the same after writing and reading, errors name the file") {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "plan.json";
  contest::Plan plan = small_plan();
  plan.params = {{"rules", {{"floor", {{"floor", 7}}}}}};
  plan.teams[1].genomes[0] = {
      .weights = {0.1 + 0.2}, .gait_genes = {1.0 / 3.0}, .body_genes = {2.0, -1e-300}, .traits = {0.1, 7.0}};
  plan.matches[0].places = (std::uint64_t{1} << 48U) - 1;
  write_new_file(path, contest::text_of(plan));
  const contest::Plan read = contest::read_plan(path);
  CHECK(contest::text_of(read) == contest::text_of(plan));
  for (const auto part : {&Genome::weights, &Genome::gait_genes, &Genome::body_genes, &Genome::traits})
    for (std::size_t one = 0; one < 10; ++one) CHECK(read.teams[1].genomes[one].*part == plan.teams[1].genomes[one].*part);
  CHECK(read.matches[0].places == plan.matches[0].places);

  const auto outcomes = folder.path() / "outcomes";
  write_new_file(outcomes, contest::text_of(std::vector{contest::Outcome{.contact_s = 0.1, .contacted = 0.25}}));
  CHECK(contest::read_outcomes(outcomes, 1)[0].contact_s == 0.1);
  CHECK(message_of<std::invalid_argument>([&] { static_cast<void>(contest::read_outcomes(outcomes, 2)); }) ==
        outcomes.string() + ": has 1 outcomes: must have 2");
  CHECK(
      message_of<std::invalid_argument>([&] { static_cast<void>(contest::read_plan(outcomes)); }).starts_with(outcomes.string()));
  plan.matches[0].hunters = 2;
  const auto wrong = folder.path() / "wrong.json";
  write_new_file(wrong, contest::text_of(plan));
  CHECK(message_of<std::invalid_argument>([&] { static_cast<void>(contest::read_plan(wrong)); }) ==
        wrong.string() + ": matches: a team that is not there");
  plan.matches[0].hunters = 0;
  std::string newer = contest::text_of(plan);
  const auto of_newer = folder.file("newer.json", newer.replace(newer.find("\"version\":1"), 11, "\"version\":2"));
  CHECK(message_of<std::invalid_argument>([&] { static_cast<void>(contest::read_plan(of_newer)); }) ==
        of_newer + ": version = 2: must be 1, which this program writes");
}
