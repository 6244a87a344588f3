// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <trophic/pictures/watch/clock.hpp>

using namespace trophic::watch;

TEST_CASE("clock: running -> advances at its speed and never ahead of the run") {
  Clock clock;
  CHECK(clock.speed() == 10.0);
  clock.advance(0.3, 100.0);
  CHECK(clock.time_s() == doctest::Approx(3.0));
  clock.advance(1.0, 4.0);
  CHECK(clock.time_s() == 4.0);
  clock.advance(1.0, 2.0);
  CHECK(clock.time_s() == 4.0);
  CHECK(clock.wanted_until_s(2.0) == doctest::Approx(14.0));
}

TEST_CASE("clock: paused -> stands and asks for one tick, until it is resumed") {
  Clock clock;
  clock.set(6.0);
  clock.pause_or_continue();
  clock.advance(5.0, 100.0);
  CHECK(clock.time_s() == 6.0);
  CHECK(clock.text() == "6.0 s, paused");
  CHECK(clock.wanted_until_s(2.0) == 8.0);
  clock.pause_or_continue();
  clock.advance(0.1, 100.0);
  CHECK(clock.time_s() == doctest::Approx(7.0));
  CHECK(clock.text() == "7.0 s, 10x");
}

TEST_CASE("clock: step -> ends at the next tick, waits for the run, and steps add up") {
  Clock clock;
  clock.set(5.3);
  clock.step(2.0);
  CHECK(clock.wanted_until_s(2.0) == 6.0);
  clock.advance(0.0, 5.5);
  CHECK(clock.time_s() == 5.5);
  clock.advance(0.0, 8.0);
  CHECK(clock.time_s() == 6.0);
  clock.advance(9.0, 100.0);
  CHECK(clock.time_s() == 6.0);
  CHECK(clock.is_paused());
  clock.step(2.0);
  clock.step(2.0);
  clock.advance(0.0, 100.0);
  CHECK(clock.time_s() == 10.0);
}

TEST_CASE("clock: faster or slower -> speeds have limits, and the last is the run's own") {
  Clock clock;
  for (int i = 0; i < 30; ++i) clock.slower();
  CHECK(clock.speed() == 0.1);
  CHECK(clock.text() == "0.0 s, 0.1x");
  for (int i = 0; i < 30; ++i) clock.faster();
  clock.advance(0.01, 1234.0);
  CHECK(clock.time_s() == 1234.0);
  CHECK(clock.text() == "1234.0 s, as fast as possible");
  CHECK(clock.wanted_until_s(2.0) == std::numeric_limits<double>::infinity());
  clock.advance(0.5, 1734.0);
  CHECK(clock.pace() == doctest::Approx(1000.0));
  clock.slower();
  CHECK(clock.pace() == 500.0);
}
