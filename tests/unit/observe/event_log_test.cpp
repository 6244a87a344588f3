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
