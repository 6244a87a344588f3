// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <sstream>
#include <string>
#include <thread>
#include <tools/replicates/joint_progress.hpp>
#include <unit/observe/scene.hpp>
#include <vector>

using namespace trophic;

TEST_CASE("joint progress: concurrent runs -> one line for each that ends") {
  std::ostringstream out;
  replicates::JointProgress joint{8, 6.0, out, false};
  {
    std::vector<std::jthread> threads;
    for (int run = 0; run < 8; ++run) {
      threads.emplace_back([&joint, run] {
        test::HandPopulation robots = test::three_robots();
        auto part = joint.watch("run-" + std::to_string(run));
        part.on_start(test::short_run(), robots.at_tick(0).view());
        for (std::int64_t tick = 1; tick <= 3; ++tick) part.on_tick(robots.at_tick(tick).view());
        if (run == 5) {
          part.on_failure("diverged");
        } else {
          part.on_end(robots.view());
        }
      });
    }
  }
  std::istringstream lines{out.str()};
  int ended = 0;
  int failed = 0;
  for (std::string line; std::getline(lines, line);) {
    REQUIRE(line.starts_with("run-"));
    if (line == "run-5  failed: diverged") {
      ++failed;
    } else {
      CHECK(line.find("  6.0 s, 0 deaths, ") == 5);
      ++ended;
    }
  }
  CHECK(ended == 7);
  CHECK(failed == 1);
}
