// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/temporary_folder.hpp>
#include <trophic/io/agent_log.hpp>
#include <unit/observe/scene.hpp>

using namespace trophic;

TEST_CASE("agents: run -> a row per robot and tick, empty cells without a value") {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "agents.csv";
  const test::HandPopulation robots = test::three_robots();
  io::AgentLog log{path};
  log.on_tick(robots.view());
  CHECK(test::content(path) ==
        "time_s,tick,body,id,species,origin,active,tag,x_m,y_m,heading_rad,target_angle_rad,adversary_id,adversary_distance_m,"
        "hunger_ticks\n"
        "6,3,0,7,predator,random,1,-1,1.500000,-2.000000,0.000000,0.700000,8,2.500000,2\n"
        "6,3,1,8,prey,random,1,-1,0.250000,0.000000,0.500000,0.000000,,,\n"
        "6,3,2,9,prey,inherited,0,1,0.000000,4.000000,0.000000,0.000000,,,\n");
}

TEST_CASE("agents: thinned -> ticks that are multiples, including the start") {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "agents.csv";
  test::HandPopulation robots{{{}}};
  io::AgentLog log{path, Opening::created, 3};
  for (std::int64_t tick = 0; tick <= 7; ++tick) log.on_tick(robots.at_tick(tick).view());
  CHECK(log.sum().rows == 3);
  const std::string text = test::content(path);
  for (const char* row : {"\n0,0,0,", "\n6,3,0,", "\n12,6,0,"}) CHECK(text.find(row) != std::string::npos);
  CHECK_THROWS_WITH_AS(io::AgentLog(folder.path() / "none.csv", Opening::created, 0), "agents_every_ticks = 0: must be >= 1",
                       std::invalid_argument);
}
