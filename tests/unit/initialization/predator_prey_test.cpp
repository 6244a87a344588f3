// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <stdexcept>
#include <trophic/initialization/community/predator_prey.hpp>
#include <vector>

using namespace trophic;
using initialization::community::PredatorPrey;

TEST_CASE("predator prey: web -> predators eat prey, no other link") {
  const FoodWeb web = PredatorPrey{}.web();
  REQUIRE(web.size() == 2);
  CHECK(web.name(PredatorPrey::prey) == "prey");
  CHECK(web.name(PredatorPrey::predator) == "predator");
  CHECK(web.eats(PredatorPrey::predator, PredatorPrey::prey));
  CHECK_FALSE(web.eats(PredatorPrey::prey, PredatorPrey::predator));
  CHECK_FALSE(web.eats(PredatorPrey::predator, PredatorPrey::predator));
  CHECK(web.links().size() == 1);
}

TEST_CASE("predator prey: default -> 16 prey, then 14 predators") {
  const std::vector<Species> founders = PredatorPrey{}.founders(30);
  REQUIRE(founders.size() == 30);
  for (std::size_t body = 0; body < 30; ++body) {
    CHECK(founders[body] == (body < 16 ? PredatorPrey::prey : PredatorPrey::predator));
  }
}

TEST_CASE("predator prey: other numbers, none or all predators -> as set") {
  const auto predators = [](std::size_t count, std::size_t robots) {
    return std::ranges::count(PredatorPrey{{.predators = count}}.founders(robots), PredatorPrey::predator);
  };
  CHECK(predators(0, 5) == 0);
  CHECK(predators(5, 5) == 5);
  CHECK(predators(100, 300) == 100);
}

TEST_CASE("predator prey: more predators than bodies -> error with both numbers") {
  CHECK_THROWS_WITH_AS(static_cast<void>(PredatorPrey{}.founders(13)),
                       "rules.community.predators = 14: must be <= 13, the number of robots", std::invalid_argument);
}
