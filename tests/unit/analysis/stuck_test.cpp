// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <tools/analysis/metrics/stuck.hpp>
#include <unit/reading/rows.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::test;
using analysis::AgentRow;
using analysis::stuck;

TEST_CASE("stuck: less than 5 cm away after 10 s -> stuck, wherever it was meanwhile") {
  std::vector<AgentRow> agents;
  for (std::int64_t tick = 0; tick <= 5; ++tick) {
    const auto t = static_cast<double>(tick);
    agents.push_back(robot(tick, 0, prey, 0.0, 0.0098 * t));                 // 4.9 cm
    agents.push_back(robot(tick, 1, prey, 3.0 + 0.0102 * t, 0.0));           // 5.1 cm
    agents.push_back(robot(tick, 2, predator, tick == 3 ? 5.0 : 1.0, 1.0));  // went away and came back
    agents.push_back(robot(tick, 3, predator, 9.0 - 0.5 * t, 9.0, {}, Origin::random));
    agents.push_back(robot(tick, 4, predator, 9.0 - 0.5 * t, 2.0));
  }
  CHECK(*stuck(agents, prey).mean() == doctest::Approx(1.0 / 2.0));
  CHECK(*stuck(agents, predator).mean() == doctest::Approx(1.0 / 3.0));
  CHECK(*stuck(agents, {}).mean() == doctest::Approx(2.0 / 5.0));
  CHECK(*stuck(agents, prey, 0.06).mean() == 1.0);
}

TEST_CASE("stuck: birth meanwhile -> the body counts for its species at the start") {
  std::vector<AgentRow> agents{robot(0, 0, prey, 1.0, 1.0), robot(5, 0, predator, 1.0, 1.0)};
  agents[1].id = 77;
  CHECK(*stuck(agents, prey).mean() == 1.0);
  CHECK_FALSE(stuck(agents, predator).mean());
}

TEST_CASE("stuck: no tick 10 s later -> no value") {
  const std::vector<AgentRow> agents{robot(0, 0, prey, 1.0, 1.0), robot(4, 0, prey, 1.0, 1.0), robot(6, 0, prey, 1.0, 1.0)};
  CHECK_FALSE(stuck(agents, prey).mean());
  CHECK_FALSE(stuck({}, prey).mean());
}
