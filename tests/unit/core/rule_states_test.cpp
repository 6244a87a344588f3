// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/odometer.hpp>
#include <support/temporary_folder.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/death/senescence/old_age.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/io/state_log.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/released.hpp>

using namespace trophic;
using perception::sensors::List;

namespace {

/// Counts what its body goes through. Nobody dies of it.
struct Diary {
  static constexpr std::string_view name = "diary";
  struct State {
    double walked_m = 0.0;
    std::size_t catches = 0;    ///< of this individual
    std::size_t caught = 0;     ///< in this body, ever
    std::size_t sighted = 0;    ///< of this individual
    std::size_t looked = 0;     ///< of this individual
    std::size_t ancestors = 0;  ///< in an unbroken line of living parents
    static constexpr auto fields() {
      return std::tuple{field("walked_m", &State::walked_m), field("catches", &State::catches),
                        field("caught", &State::caught),     field("sighted", &State::sighted),
                        field("looked", &State::looked),     field("ancestors", &State::ancestors)};
    }
  };
  [[nodiscard]] State born(const Individual&, const State* parent, const State& body) const {
    State born;
    born.caught = body.caught;
    born.ancestors = parent != nullptr ? parent->ancestors + 1 : 0;
    return born;
  }
  void on_walk(State& own, BodyIndex, double distance_m, const View&) const { own.walked_m += distance_m; }
  void on_catch(State& own, BodyIndex, BodyIndex, const View&) const { ++own.catches; }
  void on_caught(State& own, BodyIndex, BodyIndex, const View&) const { ++own.caught; }
  void on_sighting(State& own, BodyIndex, const std::optional<Sighting>& sighting, const View&) const {
    ++own.looked;
    if (sighting) ++own.sighted;
  }
  [[nodiscard]] bool dies(const Individual&, const View&, Rng&) const { return false; }
};

/// Counts the same from outside.
template <class Rules>
struct Watch {
  explicit Watch(const Ecology<Rules>& run) : ecology{run} {}

  void on_event(const observe::Event& event, const View& view) {
    const Diary::State& own = ecology.states().senescence[event.body];
    seen.resize(view.robots.size());
    Diary::State& mine = seen[event.body];
    if (event.kind == observe::EventKind::birth) {
      std::optional<std::size_t> parent;
      for (BodyIndex body = 0; body < view.robots.size() && event.individual.parent(); ++body) {
        if (body != event.body && view.robots[body].id == event.individual.parent()) parent = seen[body].ancestors;
      }
      mine = {.caught = mine.caught, .ancestors = parent && inherits ? *parent + 1 : 0};
      CHECK(own.ancestors == mine.ancestors);
      CHECK(own.catches == 0);
      longest = std::max(longest, own.ancestors);
    }
    if (event.kind == observe::EventKind::capture) {
      ++mine.catches;
      for (BodyIndex body = 0; body < view.robots.size(); ++body) {
        if (view.robots[body].id == event.other) ++seen[body].caught;
      }
    }
  }
  void on_tick(const View& view) {
    for (BodyIndex body = 0; body < view.robots.size(); ++body) {
      const Diary::State& own = ecology.states().senescence[body];
      Diary::State& mine = seen[body];
      if (!before.empty() && view.robots[body].born_s < view.time_s) mine.walked_m += distance_m(before[body], view.poses[body]);
      ++mine.looked;
      if (view.robots[body].adversary) ++mine.sighted;
      CHECK(first_difference(own, mine) == "");
    }
    before.assign(view.poses.begin(), view.poses.end());
  }

  const Ecology<Rules>& ecology;
  bool inherits = true;
  std::vector<Diary::State> seen;
  std::vector<GroundPose> before;
  std::size_t longest = 0;
};

std::vector<std::string> lines_of(const std::filesystem::path& path) {
  std::ifstream file{path};
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

}  // namespace

TEST_CASE("rule states: events of bodies -> hooks called, birth -> state from born") {
  using Rules = with_senescence<rules::Paper, Diary>;
  Ecology<Rules> ecology{{.seed = 5}, backend::Kinematic::Params{}};
  Watch<Rules> watch{ecology};
  ecology.run_until(1500.0, watch);
  CHECK(watch.longest > 2);
}

TEST_CASE("rule states: nothing inherited -> states not inherited") {
  using Rules = with_senescence<rules::Paper, Diary>;
  Ecology<Rules> ecology{{.seed = 5, .null = Null::shadow}, backend::Kinematic::Params{}};
  Watch<Rules> watch{ecology};
  watch.inherits = false;
  ecology.run_until(500.0, watch);
  CHECK(watch.longest == 0);
}

TEST_CASE("rule states: rule that only records -> same run") {
  Ecology<rules::Paper> plain{{.seed = 5}, backend::Kinematic::Params{}};
  Ecology<with_senescence<rules::Paper, Diary>> kept{{.seed = 5}, backend::Kinematic::Params{}};
  plain.run_until(500.0);
  kept.run_until(500.0);
  for (BodyIndex body = 0; body < 30; ++body) {
    CHECK(plain.view().robots[body].id == kept.view().robots[body].id);
    CHECK(plain.view().poses[body].x_m == kept.view().poses[body].x_m);
  }
}

TEST_CASE("rule states: table without states -> empty") {
  std::size_t visited = 0;
  for_each_state(RuleStates<rules::Paper>{}, [&](std::string_view, const auto&) { ++visited; });
  CHECK(visited == 0);
  std::vector<std::string> slots;
  for_each_state(RuleStates<rules::Released>{}, [&](std::string_view slot, const auto&) { slots.emplace_back(slot); });
  CHECK(slots == std::vector<std::string>{"parent.starved", "parent.sacrificed", "starvation.exemption"});
}

TEST_CASE("state log: states -> a column per member, a row per robot and tick") {
  const test::TemporaryFolder folder;
  Ecology<rules::Released> ecology{{.seed = 6}, backend::Kinematic::Params{}};
  io::StateLog log{folder.path() / "states.csv", ecology.state_columns()};
  ecology.run_until(200.0, log);
  const auto lines = lines_of(folder.path() / "states.csv");
  REQUIRE(lines.size() == 1 + 101 * 30);
  CHECK(lines[0] ==
        "time_s,tick,body,id,parent.starved.body,parent.starved.victim,parent.sacrificed.killer,starvation.exemption.adversary_"
        "distance_m");
  CHECK(lines[1] == "0,0,0,0,,,,0");
  const auto& states = ecology.states();
  for (BodyIndex body = 0; body < 30; ++body) {
    const auto id = [](const std::optional<Ancestor>& one) { return one ? number_text(one->id) : ""; };
    const auto& seen = states.parent.part<1>()[body];
    CHECK(lines[1 + 100 * 30 + body] == "200,100," + number_text(body) + "," + number_text(ecology.view().robots[body].id) + "," +
                                            (seen.body ? number_text(*seen.body) : "") + "," + id(seen.victim) + "," +
                                            id(states.parent.part<2>()[body].killer) + "," +
                                            number_text(states.starvation.part<1>()[body].adversary_distance_m));
  }
}

TEST_CASE("rule states: sensor with a state -> one per body, read by the sensor, in the state log") {
  using Sensors = List<perception::sensors::SideOfAdversary, test::Odometer, perception::sensors::TagRatioOfAll>;
  using Rules = with_senescence<with_sensors<rules::Paper, Sensors>, Diary>;
  struct Told {
    [[nodiscard]] bool wants_decisions() const { return true; }
    void on_decision(const observe::DecisionRecord& decision, const View&) {
      CHECK(decision.inputs[1] == ecology.states().sensors[decision.body].get<1>().walked_m);
      CHECK(decision.inputs[1] == ecology.states().senescence[decision.body].walked_m);
      ++decisions;
    }
    const Ecology<Rules>& ecology;
    std::size_t decisions = 0;
  };
  const test::TemporaryFolder folder;
  Ecology<Rules> ecology{{.seed = 6}, backend::Kinematic::Params{}};
  Told told{ecology};
  io::StateLog log{folder.path() / "states.csv", ecology.state_columns()};
  ecology.run_until(400.0, told, log);
  CHECK(told.decisions > 1000);
  const auto lines = lines_of(folder.path() / "states.csv");
  CHECK(lines[0].starts_with("time_s,tick,body,id,sensors.odometer.walked_m,senescence.walked_m,"));
  CHECK(lines.back().starts_with("400,200,29,"));
}

TEST_CASE("state log: table without states -> only the first four columns") {
  const test::TemporaryFolder folder;
  Ecology<rules::Paper> ecology{{}, backend::Kinematic::Params{}};
  io::StateLog log{folder.path() / "states.csv", ecology.state_columns()};
  ecology.run_until(0.0, log);
  const auto lines = lines_of(folder.path() / "states.csv");
  REQUIRE(lines.size() == 31);
  CHECK(lines[0] == "time_s,tick,body,id");
  CHECK(lines[30] == "0,0,29,29");
}
