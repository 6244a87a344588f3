// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

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

TEST_CASE("progress: events -> counted in the summary, with the engine's remarks") {
  const test::HandPopulation robots = test::three_robots();
  const View view = robots.view();
  observe::RunDescription run = test::short_run();
  run.remarks = {"physics.gravity_m_s2 has no effect"};
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
  for (const char* said : {"seed 5", "6.0 simulated s", "physics.gravity_m_s2 has no effect", "3 (3 founders; 1 inherited)",
                           "1 (1 caught, 0 starved, 0 sacrificed, 0 senescence)", "2 prey 1 predator"}) {
    CHECK_MESSAGE(out.str().find(said) != std::string::npos, said);
  }
}
