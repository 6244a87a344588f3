// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>

using namespace trophic;
using namespace trophic::test;

TEST_CASE("food web: chain of three -> feeding relations") {
  const FoodWeb web = chain_web();
  CHECK(web.size() == 3);
  CHECK(web.eats(grazer, plant));
  CHECK(web.eats(hunter, grazer));
  CHECK_FALSE(web.eats(hunter, plant));
  CHECK_FALSE(web.eats(plant, grazer));
  CHECK(web.opponents(plant, grazer));
  CHECK(web.opponents(grazer, plant));
  CHECK_FALSE(web.opponents(plant, hunter));
  CHECK_FALSE(web.opponents(plant, plant));
  CHECK_FALSE(web.hunts(plant));
  CHECK((web.hunts(grazer) && web.hunts(hunter)));
  CHECK((web.is_hunted(plant) && web.is_hunted(grazer)));
  CHECK_FALSE(web.is_hunted(hunter));
  CHECK(web.first_victim(hunter) == grazer);
  CHECK(web.first_victim(plant) == std::nullopt);
}

TEST_CASE("food web: several victims -> the first, cannibals -> allowed") {
  const FoodWeb web{{"a", "b", "c"}, {{.hunter = 2, .victim = 1}, {.hunter = 2, .victim = 0}, {.hunter = 2, .victim = 2}}};
  CHECK(web.first_victim(2) == 1);
  CHECK(web.opponents(2, 2));
}

TEST_CASE("food web: link to a species without a name -> error") {
  CHECK_THROWS_WITH_AS((FoodWeb{{"a", "b"}, {{.hunter = 2, .victim = 0}}}),
                       "food web: link 2 eats 0: must be < 2, the number of species", std::invalid_argument);
  CHECK_THROWS_AS((FoodWeb{{"a", "b"}, {{.hunter = 0, .victim = 2}}}), std::invalid_argument);
}
