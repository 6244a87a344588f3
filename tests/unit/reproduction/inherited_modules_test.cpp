// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cstdint>
#include <set>
#include <stdexcept>
#include <string>
#include <trophic/habitat/load/robot.hpp>
#include <trophic/params/numbers_text.hpp>
#include <trophic/reproduction/body_plan/inherited_modules.hpp>
#include <unit/reproduction/births.hpp>
#include <vector>

using namespace trophic;
using reproduction::body_plan::InheritedModules;

namespace {

Habitat spiders() {
  Habitat habitat{.robot = load_robot("spider"), .arena = {}, .gait = {}};
  habitat.design = load_design("spider");
  return habitat;
}

}  // namespace

TEST_CASE("inherited modules: first body 0 -> that of ecology.robot, itself in every number") {
  const Habitat habitat = spiders();
  Rng rng{1, Stream::user};
  const InheritedModules rule;
  const std::vector<double> genes = rule.draw(0, habitat, rng);
  CHECK(genes == body::genes_of(habitat.design->modules));
  CHECK(numbers_text(body::build(rule.grow(genes, 0, habitat))) == numbers_text(habitat.robot));
  CHECK(rng.bits() == Rng{1, Stream::user}.bits());
}

TEST_CASE("inherited modules: random first body -> as many modules, with the parts of ecology.robot") {
  Habitat habitat = spiders();
  habitat.design->friction = 0.7;
  habitat.design->servo.position_gain = 3.0;
  Rng rng{1, Stream::user};
  const InheritedModules rule{{.first_modules = 6, .mutation = {}}};
  const std::vector<double> genes = rule.draw(0, habitat, rng);
  CHECK(genes.size() == 4 * 5);
  const RobotModel robot = body::build(rule.grow(genes, 0, habitat));
  CHECK(robot.name == "modules");
  CHECK(robot.friction == 0.7);
  CHECK(robot.forward_rad == habitat.robot.forward_rad);
  CHECK(robot.walk.speed_m_s == 0.0);
  for (const Hinge& hinge : robot.hinges) CHECK(hinge.servo.position_gain == 3.0);
}

TEST_CASE("inherited modules: mutation of a leg -> never the core alone") {
  const Habitat habitat = spiders();
  InheritedModules::Params params{
      .mutation = {.add = 0, .remove = 0, .cut = 1, .copy = 0, .mirror = 0, .swap = 0, .turn = 0, .change = 0}};
  const InheritedModules rule{params};
  std::set<std::string> found;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Rng rng{seed, Stream::user};
    std::vector<double> genes = body::genes_of(body::read_plan("core[left:hinge0[front:brick0]]"));
    rule.mutate(genes, {}, habitat, rng);
    found.insert(body::text_of(body::tree_of(genes)));
  }
  CHECK(found == std::set<std::string>{"core[left:hinge0]", "core[left:hinge0[front:brick0]]"});
}

TEST_CASE("inherited modules: habitat without a design, genes of no plan -> one sentence") {
  const InheritedModules rule;
  Rng rng{1, Stream::user};
  CHECK_THROWS_WITH_AS(static_cast<void>(rule.draw(0, Habitat{}, rng)),
                       "rules.body_plan = inherited_modules: the habitat must have the design of its robot",
                       std::invalid_argument);
  CHECK_THROWS_AS(static_cast<void>(rule.grow(std::vector<double>{0, 0, 1}, 0, spiders())), std::invalid_argument);
}

TEST_CASE("inherited modules: 300 births -> viable bodies of many plans, each with a gait, refused mutations counted") {
  test::Births<test::Evolving> births;
  std::set<std::string> plans;
  for (BodyIndex birth = 0; birth < 300; ++birth) {
    const BodyIndex body = birth % 4;
    const Individual& born = births.birth(body, (body + 1 + birth / 4 % 3) % 4);
    const Phenotype& own = births.population->phenotypes()[body];
    REQUIRE(own.robot);
    CHECK_FALSE(body::refusal(own.design->modules, *own.robot, {}));
    CHECK(body::genes_of(own.design->modules) == born.genome->body_genes);
    REQUIRE(own.gait);
    CHECK_NOTHROW(check_fit(*own.gait, *own.robot));
    plans.insert(body::text_of(own.design->modules));
  }
  CHECK(plans.size() > 30);
  CHECK(births.population->refused_bodies() > 0);
}

TEST_CASE("inherited modules: first robot -> its body, itself in every number, and one that is not loaded -> one sentence") {
  Habitat habitat = spiders();
  habitat.robots.push_back({.name = "gecko", .design = load_design("gecko"), .robot = {}, .gait = {}});
  const InheritedModules rule{{.mutation = {}, .first_robot = "gecko"}};
  CHECK(rule.robots() == std::vector<std::string>{"gecko"});
  Rng rng{1, Stream::user};
  const std::vector<double> genes = rule.draw(0, habitat, rng);
  CHECK(numbers_text(body::build(rule.grow(genes, 0, habitat))) == numbers_text(load_robot("gecko")));
  CHECK_THROWS_WITH_AS(static_cast<void>(rule.draw(0, spiders(), rng)),
                       "rules.body_plan.first_robot = \"gecko\": must be a model of the habitat", std::invalid_argument);
}

TEST_CASE("inherited modules: rate -> factor of each probability, and 0 changes no body") {
  CHECK(body::TreeMutation{}.times(0.5).add == 0.5 * body::TreeMutation{}.add);
  CHECK(body::TreeMutation{}.times(0.5).change == 0.5 * body::TreeMutation{}.change);
  const Habitat habitat = spiders();
  const InheritedModules rule{{.mutation = {}, .rate = 0.0}};
  Rng rng{1, Stream::user};
  const std::vector<double> first = body::genes_of(habitat.design->modules);
  std::vector<double> genes = first;
  for (int birth = 0; birth < 50; ++birth) rule.mutate(genes, {}, habitat, rng);
  CHECK(genes == first);
}
