// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <trophic/measure/tables.hpp>
#include <unit/measure/rows.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::test;

TEST_CASE("rows are cut into ticks, and found in one by individual or by body") {
  const std::vector<measure::AgentRow> agents{robot(1, 7, prey, 0, 0), robot(1, 3, prey, 0, 0), robot(4, 3, prey, 5, 0)};
  const auto moments = measure::by_tick(agents);
  REQUIRE(moments.size() == 2);
  CHECK(moments[0].size() == 2);
  CHECK(moments[1].front().tick == 4);
  const measure::Moment first{moments[0]};
  CHECK(first.find(3) == &agents[1]);
  CHECK(first.find(7) == &agents[0]);
  CHECK(first.find(5) == nullptr);
  CHECK(first.find_body(3) == &agents[1]);
  CHECK(first.find_body(0) == nullptr);
  CHECK(measure::by_tick({}).empty());
}

TEST_CASE("groups by origin, shares of nothing") {
  using measure::Group;
  CHECK(measure::belongs(Origin::random, Group::all));
  CHECK(measure::belongs(Origin::random, Group::random));
  CHECK_FALSE(measure::belongs(Origin::random, Group::inherited));
  CHECK_FALSE(measure::belongs(Origin::inherited, Group::random));
  CHECK(measure::belongs(Origin::inherited, Group::inherited));
  CHECK(*measure::share(1, 4) == 0.25);
  CHECK_FALSE(measure::share(0, 0));
}
