// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <trophic/observe/tally.hpp>
#include <unit/observe/scene.hpp>

using namespace trophic;
using observe::EventKind;

TEST_CASE("tally: events -> births by origin, deaths by cause") {
  const test::HandPopulation robots = test::three_robots();
  const View view = robots.view();
  observe::Tally tally;
  for (BodyIndex body = 0; body < 3; ++body) {
    tally.on_event({.kind = EventKind::birth, .body = body, .individual = view.robots[body], .cause = {}, .other = {}}, view);
  }
  tally.on_event({.kind = EventKind::capture, .body = 0, .individual = view.robots[0], .cause = {}, .other = 8}, view);
  tally.on_event({.kind = EventKind::death, .body = 1, .individual = view.robots[1], .cause = Cause::starved, .other = {}}, view);
  CHECK(tally.births() == 3);
  CHECK(tally.births(Origin::inherited) == 1);
  CHECK(tally.deaths() == 1);
  CHECK(tally.deaths(Cause::starved) == 1);
  CHECK(tally.deaths(Cause::caught) == 0);
}
