// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cstdint>
#include <trophic/observe/frame.hpp>

using namespace trophic;
using observe::FrameTimes;

TEST_CASE("frames: any rate -> same frames every tick, evenly spaced, the last at its end") {
  const FrameTimes times{.steps = 120, .tick_s = 2.0, .clock_scale = 1.0};
  CHECK(times.per_tick(5.0) == 10);
  CHECK(times.per_tick(0.0) == 0);
  CHECK(times.per_tick(0.01) == 1);
  CHECK(times.per_tick(1e6) == 120);
  CHECK(FrameTimes{.steps = 120, .tick_s = 2.0, .clock_scale = 0.5}.per_tick(5.0) == 5);
  for (const double hz : {0.1, 3.5, 5.0, 7.0, 30.0, 59.0, 60.0, 1000.0}) {
    CAPTURE(hz);
    const std::int64_t frames = times.per_tick(hz);
    std::int64_t step = 0;
    for (std::int64_t frame = 1; frame <= frames; ++frame) {
      const std::int64_t next = times.next(step, hz);
      REQUIRE(next == times.step_of(frame, frames));
      for (std::int64_t between = step + 1; between < next; ++between) REQUIRE_FALSE(times.due(between, hz));
      REQUIRE(times.due(next, hz));
      step = next;
    }
    CHECK(step == times.steps);
    CHECK(times.due(0, hz));
  }
  CHECK_FALSE(times.due(0, 0.0));
  CHECK(times.next(17, 0.0) == times.steps);
}
