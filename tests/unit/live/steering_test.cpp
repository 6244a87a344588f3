// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <chrono>
#include <future>
#include <string>
#include <tools/live/steering.hpp>
#include <vector>

using namespace trophic;

namespace {

struct Heard final : live::Listener {
  std::vector<std::string> texts;
  void refused(const std::string& why) override { texts.push_back(why); }
};

struct Steered {
  Heard heard;
  live::Steering steering{heard};
  Steered() {
    steering.begin(2.0, {});
    steering.set_visible();
    steering.set_speed(0.0);
  }
  /// Whether the run waits until `wish` is called.
  template <class Wish>
  [[nodiscard]] bool waits_for(Wish&& wish) {
    auto due = std::async(std::launch::async, [&] { return steering.due(0.0); });
    const bool waits = due.wait_for(std::chrono::milliseconds{30}) == std::future_status::timeout;
    wish();
    return waits && due.get().empty();
  }
};

}  // namespace

TEST_CASE("steering: run that cannot be seen yet -> does not wait, else -> waits for the first page") {
  Heard heard;
  live::Steering steering{heard};
  steering.begin(2.0, {});
  CHECK(steering.due(0.0).empty());
  Steered steered;
  CHECK(steered.waits_for([&] { steered.steering.set_pages(1); }));
  steered.steering.set_pages(0);
  CHECK(steered.steering.due(2.0).empty());  // without pages it continues
}

TEST_CASE("steering: paused run -> waits, a tick -> one tick, play -> continues") {
  Steered steered;
  steered.steering.set_pages(1);
  steered.steering.pause();
  CHECK(steered.waits_for([&] { steered.steering.step(); }));
  CHECK(steered.waits_for([&] { steered.steering.play(); }));
  CHECK(steered.steering.due(4.0).empty());
  CHECK_FALSE(steered.steering.ends());
}

TEST_CASE("steering: speed -> ticks come no faster, as fast as it goes -> at once") {
  Steered steered;
  steered.steering.set_pages(1);
  steered.steering.set_speed(40.0);  // 50 ms a tick
  const observe::Stopwatch watch;
  for (int i = 0; i < 5; ++i) CHECK(steered.steering.due(0.0).empty());
  CHECK(watch.elapsed_s() >= 0.19);
  CHECK(steered.steering.is_paced());
  steered.steering.set_speed(0.0);
  CHECK_FALSE(steered.steering.is_paced());
}

TEST_CASE("steering: changes -> handed over once, in order, also to a paused run") {
  Steered steered;
  steered.steering.set_pages(1);
  steered.steering.pause();
  steered.steering.change({.time_s = 0.0, .number = "rules.a", .value = "1"});
  steered.steering.change({.time_s = 0.0, .number = "rules.b", .value = "2"});
  const auto due = steered.steering.due(0.0);
  REQUIRE(due.size() == 2);
  CHECK(due[0].number == "rules.a");
  CHECK(due[1].value == "2");
  CHECK(steered.waits_for([&] { steered.steering.play(); }));
}

TEST_CASE("steering: restart -> ends the run, and the next one has the changes that were made") {
  Steered steered;
  steered.steering.set_pages(1);
  observe::RunDescription run;
  run.changes = {{.time_s = 2.0, .tick = 1, .number = "rules.a", .value = "3", .before = "1"}};
  steered.steering.describe(run);
  steered.steering.restart(9, "released");
  CHECK(steered.steering.due(4.0).empty());
  CHECK(steered.steering.ends());
  const auto restart = steered.steering.wait_for_restart(0.0);
  REQUIRE(restart);
  CHECK(restart->seed == 9);
  CHECK(restart->rule_table == "released");
  REQUIRE(restart->made.size() == 1);
  CHECK(restart->made[0].value == "3");
  steered.steering.set_pages(0);
  CHECK_FALSE(steered.steering.wait_for_restart(0.0));  // no page is left
}
