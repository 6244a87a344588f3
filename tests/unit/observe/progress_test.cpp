// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <iostream>
#include <sstream>
#include <trophic/observe/progress.hpp>
#include <unit/observe/scene.hpp>

using namespace trophic;
using observe::EventKind;

TEST_CASE("progress: durations and numbers -> readable text") {
  CHECK(observe::duration_text(0.4) == "0 s");
  CHECK(observe::duration_text(59.4) == "59 s");
  CHECK(observe::duration_text(59.6) == "1 min 0 s");
  CHECK(observe::duration_text(200.0) == "3 min 20 s");
  CHECK(observe::duration_text(7500.0) == "2 h 5 min");
  CHECK(observe::short_text(3.14159) == "3.1");
  CHECK(observe::short_text(100.4) == "100");
}

TEST_CASE("progress: remarks -> on stderr before the run, each once") {
  std::ostringstream printed;
  std::streambuf* const own = std::cerr.rdbuf(printed.rdbuf());
  observe::RunDescription run = test::short_run();
  run.remarks = {"rules.floor: one", "rules.capture: two"};
  const test::HandPopulation robots = test::three_robots();
  for (int replicate = 0; replicate < 2; ++replicate) observe::Progress{false}.on_start(run, robots.view());
  run.remarks = {"rules.capture: two", "rules.floor: three"};
  observe::Progress{false}.on_change(run, robots.view());
  std::cerr.rdbuf(own);
  CHECK(printed.str() == "remark  rules.floor: one\nremark  rules.capture: two\nremark  rules.floor: three\n");
}

TEST_CASE("progress: events -> counted in the summary") {
  const test::HandPopulation robots = test::three_robots();
  const View view = robots.view();
  observe::RunDescription run = test::short_run();
  run.slots = {{"capture", "one"}, {"metabolism", "two"}};
  observe::Progress progress{false};
  test::HandPopulation before = robots;
  progress.on_start(run, before.at_tick(0).view());
  for (BodyIndex body = 0; body < 3; ++body) {
    progress.on_event({.kind = EventKind::birth, .body = body, .individual = view.robots[body], .cause = {}, .other = {}}, view);
  }
  progress.on_event({.kind = EventKind::death, .body = 1, .individual = view.robots[1], .cause = Cause::caught, .other = 7},
                    view);
  progress.on_tick(view);
  progress.on_end(view);
  std::ostringstream out;
  progress.summary(out, view);
  for (const char* said :
       {"seed 5", "6.0 simulated s", "3 (3 founders; 1 inherited)", "1 (1 caught, 0 starved)", "2 prey 1 predator"}) {
    CHECK_MESSAGE(out.str().find(said) != std::string::npos, said);
  }
  CHECK(out.str().find("gone") == std::string::npos);
}

TEST_CASE("progress: species without a member -> the summary has the time since when") {
  test::HandPopulation robots = test::three_robots();
  observe::Progress progress{false};
  progress.on_start(test::short_run(), robots.view());
  progress.on_tick(robots.at_tick(1).view());
  robots.individuals[0].species = test::prey;
  for (const std::int64_t tick : {2, 3}) progress.on_tick(robots.at_tick(tick).view());
  std::ostringstream out;
  progress.summary(out, robots.view());
  CHECK(out.str().ends_with("alive   3 prey 0 predator\ngone    predator since 4.0 s\n"));
}
