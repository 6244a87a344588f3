// SPDX-License-Identifier: MIT
// What observers are told of brains is what robots do.
#include <doctest/doctest.h>

#include <set>
#include <support/recorder.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/control/brain/feed_forward_brain.hpp>
#include <trophic/control/brain/hebbian.hpp>
#include <trophic/death/starvation/exemption/no_exemption.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/released.hpp>

using namespace trophic;

namespace {

/// Holds each deliberation to what else is known of the robot, and counts.
struct Listener {
  std::size_t inputs = 3;
  std::size_t asked = 0;
  std::size_t denied = 0;
  std::size_t switched = 0;
  std::size_t exemptions = 0;
  std::size_t ticks = 0;
  std::set<BodyIndex> asked_now = {};

  bool wants_decisions() { return true; }
  void on_decision(const observe::DecisionRecord& one, const View& view) {
    const Individual& self = view.robots[one.body];
    CHECK(asked_now.insert(one.body).second);  // once a tick
    CHECK(one.inputs.size() == inputs);
    CHECK(self.target_angle_rad == one.target_angle_rad);
    const bool wants_another = one.tag != one.tag_before;
    CHECK(self.tag == (one.might_switch ? one.tag : one.tag_before));
    denied += wants_another && !one.might_switch ? 1 : 0;
    switched += wants_another && one.might_switch ? 1 : 0;
    ++asked;
    REQUIRE(one.outputs.size() == 2);
    CHECK(one.tag == (one.outputs[1] > 0.0 ? 1 : -1));
    if (one.outputs[0] != 0.0) CHECK((one.target_angle_rad > 0.0) == (one.outputs[0] > 0.0));
  }
  void on_exemption(BodyIndex hunter, const View& view) {
    CHECK(view.web.hunts(view.robots[hunter].species));
    ++exemptions;
  }
  void on_tick(const View&) {
    asked_now.clear();
    ++ticks;
  }
};

struct CountsSwitches {
  std::size_t switches = 0;
  void on_event(const observe::Event& event, const View&) { switches += event.kind == observe::EventKind::tag_switch ? 1 : 0; }
};

template <class Rules>
Listener listen(std::uint64_t seed) {
  CAPTURE(seed);
  Ecology<Rules> ecology{{.seed = seed}, backend::Kinematic::Params{}};
  Listener listener;
  CountsSwitches events;
  test::Recorder told;
  ecology.run_until(1500.0, listener, events, told);
  CHECK(listener.switched == events.switches);

  Ecology<Rules> alone{{.seed = seed}, backend::Kinematic::Params{}};
  test::Recorder untold;
  alone.run_until(1500.0, untold);
  CHECK(told.all == untold.all);
  return listener;
}

}  // namespace

TEST_CASE("decision records: any run -> one a brain and tick, consistent with turns and switches, run unchanged") {
  for (const auto seed : {std::uint64_t{1}, std::uint64_t{2}}) {
    const Listener paper = listen<rules::Paper>(seed);
    CHECK(paper.denied > 0);
    CHECK(paper.switched > 0);
    CHECK(paper.exemptions > 0);
    CHECK(paper.asked <= 30 * paper.ticks);
    CHECK(paper.asked > 5 * paper.ticks);
    const Listener released = listen<rules::Released>(seed);
    CHECK(released.denied > 0);
  }
}

TEST_CASE("decision records: learning brain -> outputs before learning") {
  CHECK(listen<with_brain<rules::Paper, control::brain::Hebbian<control::brain::FeedForwardBrain>>>(3).asked > 0);
}

TEST_CASE("decision records: no exemption rule -> no on_exemption") {
  CHECK(listen<with_starvation_exemption<rules::Paper, death::starvation::exemption::NoExemption>>(3).exemptions == 0);
}
