// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <string_view>
#include <trophic/observe/hooks.hpp>

using namespace trophic;

namespace {

struct AllHooks {
  void on_start(const observe::RunDescription&, const View&) {}
  void on_event(const observe::Event&, const View&) {}
  void on_tick(const View&) {}
  void on_end(const View&) {}
  void on_failure(std::string_view) {}
  bool keep_running() { return true; }
  bool cancels_tick() { return false; }
  void on_decision(const observe::DecisionRecord&, const View&) {}
  bool wants_decisions() { return true; }
  void on_exemption(BodyIndex, const View&) {}
  void between_ticks(Simulation&, bool) {}
  void on_frame(const observe::Frame&) {}
  double frame_hz() { return 5.0; }
};

struct OnlyTicks {
  void on_tick(const View&) {}
};

struct OnlySaves {
  void between_ticks(Simulation&, bool) {}
};

/// Takes more than it is given: that is no error.
struct WiderTick {
  void on_tick(const View&, int = 0) const {}
  bool keep_running() const noexcept { return true; }
};

}  // namespace

TEST_CASE("hooks: any of them makes an observer, each found by its own name") {
  static_assert(observe::Observer<AllHooks> && observe::Observer<OnlyTicks> && observe::Observer<OnlySaves>);
  static_assert(observe::Observer<WiderTick>);
  using namespace observe::detail;
  CHECK(Names_on_tick<OnlyTicks>);
  CHECK_FALSE(Names_on_event<OnlyTicks>);
  CHECK(Names_between_ticks<OnlySaves>);
  CHECK_FALSE(Names_on_tick<OnlySaves>);
  CHECK(Takes_on_tick<WiderTick>);
  CHECK_FALSE(Takes_on_tick<OnlySaves>);
}
