// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/pictures/watch/exchange.hpp>
#include <trophic/pictures/watch/spectator.hpp>
#include <trophic/rules/paper.hpp>
#include <vector>

using namespace trophic;

namespace {

using Ecosystem = Ecology<rules::Paper>;

[[nodiscard]] std::vector<double> places(const Ecosystem& ecology) {
  std::vector<double> numbers;
  for (const GroundPose& pose : ecology.view().poses) numbers.insert(numbers.end(), {pose.x_m, pose.y_m, pose.heading_rad});
  return numbers;
}

}  // namespace

TEST_CASE("spectator: window shown -> the run waits for it and ends in the same state as without a window") {
  Ecosystem alone{{.seed = 5}, backend::Kinematic::Params{}};
  alone.run_until(200.0);

  Ecosystem watched{{.seed = 5}, backend::Kinematic::Params{}};
  watch::Exchange exchange;
  watch::Spectator spectator{exchange};
  std::atomic<bool> is_over = false;
  std::thread run{[&] {
    watched.run_until(200.0, spectator);
    is_over = true;
  }};
  const auto newest_s = [&] {
    return exchange.with_footage([](watch::LiveFootage& footage) { return footage.is_ready() ? footage.newest_s() : -1.0; });
  };
  const auto wait_for = [&](double time_s) {
    for (int i = 0; i < 2000 && newest_s() < time_s; ++i) std::this_thread::sleep_for(std::chrono::milliseconds{5});
    std::this_thread::sleep_for(std::chrono::milliseconds{20});
    return newest_s();
  };
  for (const double wanted_s : {0.0, 10.0, 31.0, 40.0}) {
    exchange.want_until(wanted_s);
    CHECK(wait_for(wanted_s) == 2.0 * std::ceil(wanted_s / 2.0));
  }
  CHECK_FALSE(is_over);
  exchange.with_footage([](watch::LiveFootage& footage) {
    CHECK(footage.frames() == 1 + 40 * 10);
    CHECK(footage.rows_at(40.0).size() == 30);
    CHECK(footage.until_s() == 200.0);
  });
  exchange.close();
  run.join();
  CHECK(is_over);
  CHECK(places(watched) == places(alone));
  CHECK(newest_s() == 40.0);  // without a window nothing is kept
  CHECK(spectator.frame_hz() == 0.0);
}

TEST_CASE("spectator: without a window -> asks for no frames") {
  watch::Spectator nobody;
  CHECK(nobody.frame_hz() == 0.0);
  Ecosystem ecology{{.seed = 5}, backend::Kinematic::Params{}};
  ecology.run_until(20.0, nobody);
  CHECK(ecology.time_s() == 20.0);
}
