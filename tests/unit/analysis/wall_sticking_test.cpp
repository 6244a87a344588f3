// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <tools/analysis/metrics/wall_sticking.hpp>
#include <unit/reading/rows.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::test;
using analysis::AgentRow;

using analysis::wall_sticking;

TEST_CASE("within 1 m of any wall sticks, at each tick as a share of the species") {
  const std::vector<AgentRow> agents{robot(1, 0, prey, 9.0, 0.0),    // exactly 1 m
                                     robot(1, 1, prey, 0.0, -9.5),   // the other axis, the other side
                                     robot(1, 2, prey, 8.99, 8.99),  // just too far
                                     robot(1, 3, predator, 0.0, 0.0), robot(2, 0, prey, 0.0, 0.0),
                                     robot(2, 1, prey, 11.0, 0.0),  // beyond, on a slope
                                     robot(2, 3, predator, -9.9, 9.9)};
  CHECK(*wall_sticking(agents, prey, analysis::Group::all, 10.0).mean() == doctest::Approx((2.0 / 3.0 + 1.0 / 2.0) / 2.0));
  CHECK(*wall_sticking(agents, predator, analysis::Group::all, 10.0).mean() == doctest::Approx(0.5));
  CHECK(*wall_sticking(agents, prey, analysis::Group::all, 10.0, 2.0).mean() == doctest::Approx((1.0 + 0.5) / 2.0));
}

TEST_CASE("wall sticking: ticks without a member -> left out, and no value if no tick has one") {
  const std::vector<AgentRow> agents{robot(1, 0, prey, 9.9, 0.0), robot(2, 1, predator, 0.0, 0.0),
                                     robot(3, 0, prey, 9.9, 0.0, {}, Origin::random)};
  CHECK(*wall_sticking(agents, prey, analysis::Group::all, 10.0).mean() == 1.0);
  CHECK(*wall_sticking(agents, prey, analysis::Group::random, 10.0).mean() == 1.0);
  CHECK_FALSE(wall_sticking(agents, predator, analysis::Group::random, 10.0).mean());
  CHECK_FALSE(wall_sticking(agents, 7, analysis::Group::all, 10.0).mean());
  CHECK_FALSE(wall_sticking({}, prey, analysis::Group::all, 10.0).mean());
}

TEST_CASE("wall sticking: inactive members -> not in group active, and active at that tick counts") {
  std::vector<AgentRow> agents{robot(1, 0, prey, 9.9, 0.0), robot(1, 1, prey, 0.0, 0.0), robot(2, 0, prey, 9.9, 0.0),
                               robot(2, 1, prey, 0.0, 0.0)};
  agents[1].active = false;
  CHECK(*wall_sticking(agents, prey, analysis::Group::active, 10.0).mean() == doctest::Approx((1.0 + 0.5) / 2.0));
  CHECK(*wall_sticking(agents, prey, analysis::Group::all, 10.0).mean() == doctest::Approx(0.5));
}

TEST_CASE("the rim of 1 m is 19 % of a floor of 20 m") {
  CHECK(analysis::wall_share_of_floor(10.0) == doctest::Approx(0.19));
  CHECK(analysis::wall_share_of_floor(0.5) == 1.0);
}
