// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/perception/tag_switch/free_tags.hpp>

using namespace trophic;
using namespace trophic::test;

TEST_CASE("free tags: at the time of the last switch -> may switch") {
  HandPopulation robots{{{.species = prey, .tag_since_s = 200.0}}};
  robots.at_tick(100);
  CHECK(robots.view().time_s == 200.0);
  CHECK(perception::tag_switch::FreeTags{}.may_switch(robots.individuals[0], robots.view()) == perception::MaySwitch::yes);
}
