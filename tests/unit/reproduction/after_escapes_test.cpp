// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/reproduction/recruitment/after_escapes.hpp>

using namespace trophic;
using namespace trophic::test;
using reproduction::Recruit;
using reproduction::recruitment::AfterEscapes;

namespace {

/// A predator at the origin, prey on the x axis, and spare bodies.
struct Scene {
  explicit Scene(std::vector<double> spare_x_m, AfterEscapes policy = {}) : rule{policy} {
    std::vector<Robot> list{{.species = predator}, {.x_m = 1.0}, {.x_m = 2.0}};
    for (const double x_m : spare_x_m) list.push_back({.species = no_species, .x_m = x_m, .active = false});
    robots = HandPopulation{list};
    states.resize(list.size());
  }
  /// A tick later the two prey stand at these x.
  void to(double first_x_m, double second_x_m) {
    robots.at_tick(robots.tick + 1);
    robots.poses[1].x_m = first_x_m;
    robots.poses[2].x_m = second_x_m;
    for (BodyIndex body = 0; body < 3; ++body) rule.on_walk(states[body], body, 0.0, robots.view());
  }
  [[nodiscard]] std::vector<Recruit> recruits() const {
    Rng rng{1, Stream::recruitment};
    return rule.recruits(robots.view(), rng, states);
  }
  [[nodiscard]] Recruit birth(BodyIndex parent) const {
    return {.species = prey, .parents = {robots.individuals[parent].as_ancestor()}};
  }

  AfterEscapes rule;
  HandPopulation robots{{}};
  std::vector<AfterEscapes::State> states;
};

}  // namespace

TEST_CASE("after escapes: escape -> one birth, another after the next escape") {
  Scene scene{{-9.0, 9.0}};
  scene.to(3.0, 4.0);
  CHECK(scene.recruits().empty());
  scene.to(6.0, 6.0);
  REQUIRE(scene.recruits() == std::vector{scene.birth(1)});
  scene.rule.on_offspring(scene.states[1], 1, 4, scene.robots.view());
  CHECK(scene.recruits().empty());
  scene.to(2.0, 6.0);
  scene.to(-6.0, 6.0);
  CHECK(scene.recruits() == std::vector{scene.birth(1)});
}

TEST_CASE("after escapes: fewer spare bodies than parents -> most escapes first, of equal ones the oldest") {
  Scene scene{{0.5}};
  scene.to(1.0, 1.0);
  scene.to(6.0, 6.0);
  CHECK(scene.recruits() == std::vector{scene.birth(1)});
  scene.to(6.0, 1.0);
  scene.to(6.0, 6.0);
  CHECK(scene.recruits() == std::vector{scene.birth(2)});
  scene.robots.individuals[2].active = false;
  CHECK(scene.recruits() == std::vector{scene.birth(1)});
  CHECK(Scene{{}}.recruits().empty());
}

TEST_CASE("after escapes: escapes = 2 -> birth after the second") {
  Scene scene{{0.5}, {{.escapes = 2}}};
  scene.to(1.0, 9.0);
  scene.to(6.0, 9.0);
  CHECK(scene.recruits().empty());
  scene.to(1.0, 9.0);
  scene.to(6.0, 9.0);
  CHECK(scene.recruits() == std::vector{scene.birth(1)});
}

TEST_CASE("after escapes: starvation or senescence -> spare body up to the number, other causes -> none") {
  const Scene scene{{1.0, 2.0}};
  const auto leaves_spare = [&](std::size_t spare_bodies, Cause cause) {
    return AfterEscapes{{.spare_bodies = spare_bodies}}.leaves_spare({.body = 1, .cause = cause}, scene.robots.view());
  };
  CHECK(leaves_spare(3, Cause::starved));
  CHECK(leaves_spare(3, Cause::senescence));
  CHECK_FALSE(leaves_spare(3, Cause::caught));
  CHECK_FALSE(leaves_spare(3, Cause::sacrificed));
  CHECK_FALSE(leaves_spare(2, Cause::starved));
}
