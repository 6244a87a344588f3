// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <trophic/ecology/simulation.hpp>
#include <trophic/io/state_log.hpp>
#include <unit/observe/scene.hpp>

using namespace trophic;

namespace {

struct Everything {
  std::string& told;
  bool is_running = true;
  void on_start(const observe::RunDescription& run, const View&) { told += "start " + run.rules + "\n"; }
  void on_event(const observe::Event& event, const View&) { told += "event " + std::to_string(event.body) + "\n"; }
  void on_tick(const View& view) { told += "tick " + std::to_string(view.tick) + "\n"; }
  void on_end(const View&) { told += "end\n"; }
  void on_failure(std::string_view what) { told += "failure " + std::string{what} + "\n"; }
  bool keep_running() { return is_running; }
};

struct TicksOnly {
  int ticks = 0;
  void on_tick(const View&) { ++ticks; }
};

/// Announces to its audience one moment between two ticks, and the last.
class TwoMoments final : public Simulation {
 public:
  void persist(Archive& archive) override { archive(tick_); }
  double time_s() const override { return static_cast<double>(tick_); }
  std::int64_t tick() const override { return tick_; }
  View view() const override { return robots_.view(); }
  const AnyBackend& backend() const override { throw std::logic_error{"has no bodies"}; }
  observe::RunDescription describe(double) const override { return test::short_run(); }
  io::StateColumns state_columns() const override { return {}; }

 private:
  void run(double, observe::Audience& audience) override {
    for (const bool last : {false, true}) {
      ++tick_;
      audience.between_ticks(*this, last);
    }
  }

  test::HandPopulation robots_ = test::three_robots();
  std::int64_t tick_ = 0;
};

struct Stops {
  int asked = 0;
  bool keep_running() { return ++asked < 2; }
};

}  // namespace

TEST_CASE("audience: several observers -> each hook called, in order") {
  const test::HandPopulation robots = test::three_robots();
  const View view = robots.view();
  std::string told;
  Everything first{told};
  TicksOnly second;
  Everything third{told};
  observe::AudienceOf audience{first, second, third};
  audience.start(test::short_run(), view);
  audience.event({.kind = observe::EventKind::birth, .body = 1, .individual = view.robots[1], .cause = {}, .other = {}}, view);
  audience.tick(view);
  CHECK(audience.keep_running());
  third.is_running = false;
  CHECK_FALSE(audience.keep_running());  // any of them may stop the run
  audience.failure("broken");
  audience.end(view);
  CHECK(told ==
        "start hand_written\nstart hand_written\nevent 1\nevent 1\ntick 3\ntick 3\nfailure broken\nfailure broken\nend\nend\n");
  CHECK(second.ticks == 1);
}

TEST_CASE("audience: keep_running -> every observer called") {
  std::string told;
  Everything refuses{told, false};
  Stops counts;
  observe::AudienceOf audience{refuses, counts};
  CHECK_FALSE(audience.keep_running());
  CHECK(counts.asked == 1);
}

TEST_CASE("audience: wants_decisions -> on_decision only while true") {
  struct Listens {
    bool wants = true;
    std::string told = {};
    bool wants_decisions() const { return wants; }
    void on_decision(const observe::DecisionRecord& one, const View&) { told += std::to_string(one.body); }
    void on_exemption(BodyIndex hunter, const View&) { told += "r" + std::to_string(hunter); }
  };
  const test::HandPopulation robots = test::three_robots();
  const View view = robots.view();
  Listens first;
  Listens second{.wants = false};
  TicksOnly third;
  observe::AudienceOf audience{first, second, third};
  CHECK(audience.wants_decisions());
  audience.decision({.body = 2, .inputs = {}, .outputs = {}}, view);
  audience.exemption(1, view);
  CHECK(first.told == "2r1");
  CHECK(second.told == "r1");
  first.wants = false;
  CHECK_FALSE(audience.wants_decisions());
}

TEST_CASE("audience: between_ticks -> called with the simulation") {
  struct Saves {
    std::string told = {};
    void between_ticks(Simulation& simulation, bool last) { told += std::to_string(simulation.tick()) + (last ? " last" : ", "); }
  };
  Saves saves;
  TicksOnly other;
  TwoMoments{}.run_until(10.0, other, saves);
  CHECK(saves.told == "1, 2 last");
}

TEST_CASE("audience: cancels_tick of any observer -> tick cancelled") {
  struct Impatient {
    bool is_cancelled = false;
    bool cancels_tick() const { return is_cancelled; }
  };
  TicksOnly patient;
  observe::AudienceOf nobody{patient};
  CHECK_FALSE(nobody.may_cancel());
  CHECK_FALSE(nobody.cancels_tick());
  Impatient first;
  Impatient second;
  observe::AudienceOf somebody{first, patient, second};
  CHECK(somebody.may_cancel());
  CHECK_FALSE(somebody.cancels_tick());
  second.is_cancelled = true;
  CHECK(somebody.cancels_tick());
}
