// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <optional>
#include <support/hand_population.hpp>
#include <trophic/reproduction/parent/last_escapee.hpp>
#include <vector>

#include "unit/reproduction/walks.hpp"

using namespace trophic;
using namespace trophic::test;
using reproduction::parent::LastEscapee;

TEST_CASE("last escapee: the latest escape from the dying predator -> parent, not from another one") {
  Walks<LastEscapee> walks{3};
  walks.robots().individuals[3].species = predator;  // at 20 m, then close to prey 2
  walks.to({2.0, 2.0, 20.0});
  walks.to({6.0, 2.0, 20.0});
  CHECK(walks.parent() == 1);
  walks.to({6.0, 6.0, 20.0});
  CHECK(walks.parent() == 2);
  walks.to({6.0, 18.0, 20.0});
  walks.to({19.0, 12.0, 20.0});
  walks.to({6.0, 12.0, 20.0});  // prey 1 escapes from the other predator, after prey 2 did
  CHECK(walks.parent() == 2);
  walks.robots().individuals[0].id = 77;
  CHECK(walks.parent() == std::nullopt);
}

TEST_CASE("last escapee: two at one tick -> the closest, dead predators are forgotten") {
  Walks<LastEscapee> walks{2};
  walks.to({2.0, 1.0});
  walks.to({8.0, 7.0});
  CHECK(walks.parent() == 2);
  walks.robots().individuals[0].id = 77;
  walks.to({2.0, 1.0});
  walks.to({8.0, 7.0});
  CHECK(walks.states()[1].hunters == std::vector<IndividualId>{77});
  CHECK(walks.parent() == 2);
}
