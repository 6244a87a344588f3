// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <trophic/io/event_log.hpp>
#include <unit/observe/scene.hpp>

using namespace trophic;
using observe::EventKind;

TEST_CASE("events: catch -> victim, death -> cause and killer") {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "events.csv";
  const test::HandPopulation robots = test::three_robots();
  const View view = robots.view();
  io::EventLog log{path};
  log.on_start(test::short_run(), view);
  log.on_event({.kind = EventKind::capture, .body = 0, .individual = view.robots[0], .cause = {}, .other = 8}, view);
  log.on_event({.kind = EventKind::death, .body = 1, .individual = view.robots[1], .cause = Cause::caught, .other = 7}, view);
  log.on_event({.kind = EventKind::birth, .body = 2, .individual = view.robots[2], .cause = {}, .other = {}}, view);
  log.on_tick(view);
  CHECK(test::content(path) ==
        "time_s,tick,event,id,species,body,tag,active,origin,parent_id,genome_id,cause,killer_id,victim_id,x_m,y_m\n"
        "6,3,catch,7,predator,0,-1,1,random,,7,,,8,1.500000,-2.000000\n"
        "6,3,death,8,prey,1,-1,1,random,,8,caught,7,,0.250000,0.000000\n"
        "6,3,birth,9,prey,2,1,0,inherited,8,9,,,,0.000000,4.000000\n");
}

TEST_CASE("events: a table whose births may have two parents -> the list of all parents in a last column") {
  const test::TemporaryFolder folder;
  test::HandPopulation robots = test::three_robots();
  robots.individuals[2].parents = {8, 7};
  const View view = robots.view();
  observe::RunDescription run = test::short_run();
  run.several_parents = true;
  io::EventLog log{folder.path() / "events.csv"};
  log.on_start(run, view);
  for (const BodyIndex body : {1U, 2U})
    log.on_event({.kind = EventKind::birth, .body = body, .individual = view.robots[body], .cause = {}, .other = {}}, view);
  log.on_tick(view);
  const std::string text = test::content(folder.path() / "events.csv");
  CHECK(text.find(",x_m,y_m,ancestor_list\n") != std::string::npos);
  CHECK(text.find(",0.250000,0.000000,[none]\n") != std::string::npos);
  CHECK(text.ends_with("birth,9,prey,2,1,0,inherited,8,9,,,,0.000000,4.000000,\"[8,7]\"\n"));
  CHECK(log.sum().columns.back() == std::pair<std::string, std::string_view>{"ancestor_list", "string"});
}
