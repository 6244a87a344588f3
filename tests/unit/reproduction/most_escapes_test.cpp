// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <optional>
#include <support/hand_population.hpp>
#include <trophic/reproduction/parent/most_escapes.hpp>

#include "unit/reproduction/walks.hpp"

using namespace trophic;
using namespace trophic::test;
using reproduction::parent::MostEscapes;

TEST_CASE("most escapes: from within 3 m to beyond 5 m -> one escape, whatever the way between") {
  Walks<MostEscapes> walks{1};
  for (const double x_m : {4.0, 6.0, 3.0, 5.0, 4.0, 5.0}) walks.to({x_m});
  CHECK(walks.states()[1].escapes == 0);
  CHECK(walks.parent() == std::nullopt);
  walks.to({5.01});
  CHECK(walks.states()[1].escapes == 1);
  CHECK(walks.parent() == 1);
  walks.to({9.0});
  CHECK(walks.states()[1].escapes == 1);
}

TEST_CASE("most escapes: greatest number of escapes -> parent, of equal numbers the closest") {
  Walks<MostEscapes> walks{2};
  walks.to({2.0, 2.5});
  walks.to({6.0, 7.0});
  CHECK(walks.parent() == 1);
  walks.to({6.0, 1.0});
  walks.to({6.0, 8.0});
  CHECK(walks.parent() == 2);
  walks.robots().individuals[2].active = false;
  CHECK(walks.parent() == 1);
  CHECK(walks.parent(predator) == std::nullopt);
}

TEST_CASE("most escapes: dead pursuer or inactive newborn -> no escape") {
  Walks<MostEscapes> walks{2};
  walks.robots().individuals[2].active = false;
  walks.to({2.0, 2.0});
  walks.robots().individuals[0].id = 77;
  walks.robots().individuals[2].active = true;
  walks.to({9.0, 9.0});
  CHECK(walks.states()[1].escapes == 0);
  CHECK(walks.states()[1].pursuers.empty());
  CHECK(walks.states()[2].escapes == 0);
}
