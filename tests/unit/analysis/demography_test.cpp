// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <tools/analysis/metrics/demography.hpp>
#include <unit/reading/rows.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::test;
using analysis::AgentRow;
using analysis::EventRow;

TEST_CASE("population and hunger are means over ticks") {
  std::vector<AgentRow> agents{robot(1, 0, prey, 0, 0), robot(1, 1, predator, 0, 0),
                               robot(1, 2, predator, 0, 0, {}, Origin::random), robot(2, 0, prey, 0, 0)};
  agents[1].hunger_ticks = 4;
  agents[2].hunger_ticks = 10;
  CHECK(*analysis::population_size(agents, predator, analysis::Group::all).mean() == 1.0);
  CHECK(*analysis::population_size(agents, predator, analysis::Group::random).mean() == 0.5);
  CHECK(*analysis::hunger(agents, predator).mean() == 7.0);
  CHECK_FALSE(analysis::hunger(agents, prey).mean());
  CHECK_FALSE(analysis::population_size({}, prey, analysis::Group::all).mean());
}

TEST_CASE("share of the ticks at an exact number of members") {
  const std::vector<AgentRow> agents{robot(1, 0, prey, 0, 0), robot(1, 1, predator, 0, 0), robot(2, 0, prey, 0, 0),
                                     robot(2, 1, prey, 0, 0), robot(3, 0, prey, 0, 0),     robot(3, 1, predator, 0, 0)};
  CHECK(*analysis::ticks_at(agents, predator, 1).mean() == doctest::Approx(2.0 / 3.0));
  CHECK(*analysis::ticks_at(agents, predator, 0).mean() == doctest::Approx(1.0 / 3.0));
  CHECK(*analysis::ticks_at(agents, prey, 3).mean() == 0.0);
  CHECK_FALSE(analysis::ticks_at({}, prey, 1).mean());
}

TEST_CASE("deaths by cause, in all and per window") {
  const std::vector<EventRow> events{
      death(0, 0, prey, 0, Origin::random, Cause::caught), death(200, 1, prey, 1, Origin::random, Cause::sacrificed),
      death(202, 2, prey, 2, Origin::random, Cause::caught), death(202, 3, predator, 3, Origin::random, Cause::starved)};
  CHECK(analysis::deaths(events, prey) == 3);
  CHECK(analysis::deaths(events, prey, Cause::caught) == 2);
  CHECK(analysis::deaths(events, predator, Cause::caught) == 0);
  const auto windows = analysis::deaths_per_window(events, prey, {}, 600.0);
  REQUIRE(windows.size() == 3);
  CHECK(*windows[0].value == 2.0);
  CHECK(*windows[1].value == 1.0);
  CHECK(*windows[2].value == 0.0);
  CHECK(windows[2].time_s == 600.0);
  CHECK(analysis::deaths_per_window(events, prey, {}, 200.0).size() == 1);
  CHECK(*analysis::deaths_per_window(events, prey, {}, 200.5)[1].value == 1.0);
  CHECK(analysis::deaths_per_window(events, prey, {}, 1e8).size() == 500'000);
}
