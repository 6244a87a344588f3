// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <string>
#include <string_view>
#include <trophic/observe/hooks.hpp>
#include <unit/observe/scene.hpp>

using namespace trophic;

namespace {

struct Everything {
  std::string& told;
  bool go_on = true;
  void on_start(const observe::RunDescription& run, const View&) { told += "start " + run.rules + "\n"; }
  void on_event(const observe::Event& event, const View&) { told += "event " + std::to_string(event.body) + "\n"; }
  void on_tick(const View& view) { told += "tick " + std::to_string(view.tick) + "\n"; }
  void on_end(const View&) { told += "end\n"; }
  void on_failure(std::string_view what) { told += "failure " + std::string{what} + "\n"; }
  bool keep_running() { return go_on; }
};

struct TicksOnly {
  int ticks = 0;
  void on_tick(const View&) { ++ticks; }
};

struct Stops {
  int asked = 0;
  bool keep_running() { return ++asked < 2; }
};

}  // namespace

TEST_CASE("hooks: each observer is told by the hooks that it has, in order") {
  static_assert(observe::Observer<Everything> && observe::Observer<TicksOnly>);
  const test::HandPopulation robots = test::three_robots();
  const View view = robots.view();
  std::string told;
  Everything first{told};
  TicksOnly second;
  Everything third{told};
  observe::Audience audience{first, second, third};
  audience.start(test::short_run(), view);
  audience.event({.kind = observe::EventKind::birth, .body = 1, .individual = view.robots[1], .cause = {}, .other = {}}, view);
  audience.tick(view);
  CHECK(audience.keep_running());
  third.go_on = false;
  CHECK_FALSE(audience.keep_running());  // any of them may say stop
  audience.failure("broken");
  audience.end(view);
  CHECK(told ==
        "start hand_written\nstart hand_written\nevent 1\nevent 1\ntick 3\ntick 3\nfailure broken\nfailure broken\nend\nend\n");
  CHECK(second.ticks == 1);
}

TEST_CASE("hooks: everybody is asked whether to go on, whatever another said") {
  std::string told;
  Everything refuses{told, false};
  Stops counts;
  observe::Audience audience{refuses, counts};
  CHECK_FALSE(audience.keep_running());
  CHECK(counts.asked == 1);
}

TEST_CASE("hooks: brains are told of to whom wants to know, as long as it does") {
  struct Listens {
    bool wants = true;
    std::string told = {};
    bool wants_deliberations() const { return wants; }
    void on_deliberation(const observe::Deliberation& one, const View&) { told += std::to_string(one.body); }
    void on_reprieve(BodyIndex hunter, const View&) { told += "r" + std::to_string(hunter); }
  };
  const test::HandPopulation robots = test::three_robots();
  const View view = robots.view();
  Listens first;
  Listens second{.wants = false};
  TicksOnly third;
  observe::Audience audience{first, second, third};
  CHECK(audience.wants_deliberations());
  audience.deliberation({.body = 2, .inputs = {}, .outputs = {}}, view);
  audience.reprieve(1, view);
  CHECK(first.told == "2r1");
  CHECK(second.told == "r1");
  first.wants = false;
  CHECK_FALSE(audience.wants_deliberations());
}
