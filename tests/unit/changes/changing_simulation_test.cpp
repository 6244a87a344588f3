// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <tools/changes/changing_simulation.hpp>
#include <tools/command/read_parameters.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/rules/paper.hpp>

namespace {

using namespace trophic;
using changes::Change;
using changes::ChangingSimulation;

std::unique_ptr<Simulation> make(const std::vector<Change>& made) {
  Experiment<rules::Paper> numbers{.seed = 3};
  for (const Change& change : made)
    command::read_parameters(numbers, command::read_assignment(change.number + "=" + change.value));
  validate(numbers, "");
  return std::make_unique<Ecology<rules::Paper>>(numbers, backend::Kinematic::Params{});
}

std::string state_of(Simulation& ecology) {
  Archive archive;
  ecology.persist(archive);
  return archive.bytes();
}

/// Makes changes at moments of the run, as a person would.
struct Person final : changes::Conductor {
  std::vector<Change> wishes;
  std::vector<std::string> refusals;
  std::vector<observe::ParameterChange> rows;
  double ends_at_s = 1e9;
  bool at_once = false;  ///< all that are due
  double now_s = 0.0;

  [[nodiscard]] std::vector<Change> due(double time_s) override {
    now_s = time_s;
    std::vector<Change> now;
    while (!wishes.empty() && wishes.front().time_s <= time_s && (now.empty() || at_once)) {
      now.push_back(wishes.front());
      wishes.erase(wishes.begin());
    }
    return now;
  }
  [[nodiscard]] bool ends() const override { return now_s >= ends_at_s; }
  void made(const observe::ParameterChange& row) override { rows.push_back(row); }
  void refused(const Change&, const std::string& why) override { refusals.push_back(why); }
};

struct Counts {
  int starts = 0;
  int ticks = 0;
  int ends = 0;
  int lasts = 0;
  std::vector<std::size_t> changes;  ///< number in the description, at the start and at each change
  void on_start(const observe::RunDescription& run, const View&) {
    ++starts;
    changes.push_back(run.changes.size());
  }
  void on_change(const observe::RunDescription& run, const View&) { changes.push_back(run.changes.size()); }
  void on_tick(const View&) { ++ticks; }
  void on_end(const View&) { ++ends; }
  void between_ticks(Simulation&, bool last) { lasts += last ? 1 : 0; }
};

const Change halved{20.0, "rules.capture.reach_m", "0.5"};
const Change moved{40.0, "rules.mutation.sd", "0.7"};

}  // namespace

TEST_CASE("changing ecology: no change, or one to the same value -> state of a plain run") {
  const auto plain = make({});
  plain->run_until(60.0);
  ChangingSimulation none{make, {}};
  none.run_until(60.0);
  ChangingSimulation same{make, {{30.0, "rules.capture.reach_m", "1"}}};
  same.run_until(60.0);
  const std::string expected = state_of(*plain);
  CHECK(state_of(none).ends_with(expected));
  CHECK(state_of(same).ends_with(expected));
}

TEST_CASE("changing ecology: changes of a schedule and of a person -> same state, which differs from a plain run") {
  ChangingSimulation scheduled{make, {halved, moved}};
  Counts counts;
  scheduled.run_until(100.0, counts);
  CHECK(counts.starts == 1);
  CHECK(counts.ends == 1);
  CHECK(counts.lasts == 1);
  CHECK(counts.ticks == 51);
  CHECK(counts.changes == std::vector<std::size_t>{0, 1, 2});
  Person person;
  person.wishes = {halved, moved};
  ChangingSimulation steered{make, {}, &person};
  steered.run_until(100.0);
  CHECK(state_of(steered) == state_of(scheduled));
  REQUIRE(person.rows.size() == 2);
  CHECK(person.rows[0].time_s == 20.0);
  CHECK(person.rows[0].before == "1");
  CHECK(person.rows[1].value == "0.7");
  const auto plain = make({});
  plain->run_until(100.0);
  CHECK_FALSE(state_of(scheduled).ends_with(state_of(*plain)));
}

TEST_CASE("changing ecology: read from its state between changes -> continues to the same state") {
  ChangingSimulation whole{make, {halved, moved}};
  whole.run_until(100.0);
  ChangingSimulation half{make, {halved, moved}};
  half.run_until(30.0);
  const std::string bytes = state_of(half);
  ChangingSimulation resumed{make, {}};
  Archive archive{bytes};
  resumed.persist(archive);
  archive.finish();
  Counts counts;
  resumed.run_until(100.0, counts);
  CHECK(counts.changes == std::vector<std::size_t>{1, 2});
  CHECK(state_of(resumed) == state_of(whole));
}

TEST_CASE("changing ecology: read with a schedule -> refused if it has other changes, made or to come") {
  ChangingSimulation half{make, {halved, moved}};
  half.run_until(30.0);
  const std::string bytes = state_of(half);
  const auto read_with = [&](std::vector<Change> schedule) {
    ChangingSimulation resumed{make, std::move(schedule)};
    Archive archive{bytes};
    resumed.persist(archive);
  };
  CHECK_NOTHROW(read_with({halved, moved}));
  CHECK_NOTHROW(read_with({{19.5, halved.number, "0.50"}, moved}));
  for (const std::vector<Change>& other : {std::vector{moved},
                                           {halved},
                                           {halved, moved, {50.0, moved.number, "0.9"}},
                                           {{halved.time_s, halved.number, "0.6"}, moved},
                                           {{10.0, halved.number, halved.value}, moved},
                                           {{21.0, halved.number, halved.value}, moved},
                                           {{halved.time_s, moved.number, "0.5"}, moved},
                                           {halved, {41.0, moved.number, moved.value}},
                                           {halved, {moved.time_s, moved.number, "0.8"}}}) {
    CHECK_THROWS_WITH_AS(read_with(other), doctest::Contains("changes other than"), std::invalid_argument);
  }
}

TEST_CASE("changing ecology: wrong change -> schedule refused before the run, wish refused, and the run continues") {
  for (const auto& [change, what] :
       {std::pair{Change{20.0, "rules.capture.reach_m", "-1"}, "must be > 0"},
        std::pair{Change{20.0, "rules.capture.nothing", "1"}, "nothing"},
        std::pair{Change{20.0, "ecology.robots", "40"}, "cannot change during a run"},
        std::pair{Change{20.0, "rules.community.predators", "10"},
                  "rules.community.predators = 10: must be given to a new run, with --set "
                  "rules.community.predators=10, because a run reads it only at its start"},
        std::pair{Change{20.0, "rules.steering.exponent", "3"},
                  "rules.steering.exponent = 3: must be omitted, because it has no effect: kinematic "
                  "has no joints"}}) {
    CHECK_THROWS_WITH_AS((ChangingSimulation{make, {change}}), doctest::Contains(what), std::invalid_argument);
    Person person;
    person.wishes = {change};
    ChangingSimulation steered{make, {}, &person};
    steered.run_until(40.0);
    REQUIRE(person.refusals.size() == 1);
    CHECK(person.refusals[0].find(what) != std::string::npos);
    const auto plain = make({});
    plain->run_until(40.0);
    CHECK(state_of(steered).ends_with(state_of(*plain)));
  }
}

TEST_CASE("changing ecology: wishes of one moment -> each taken or refused alone, each its row, and made again by a schedule") {
  Person person;
  person.at_once = true;
  const std::string reach = "rules.capture.reach_m", tag = "rules.newborn_tag.founder_tag";
  person.wishes = {{20.0, reach, "0.5"}, {20.0, reach, "-1"},         {20.0, reach, "0.40"},
                   {20.0, tag, "7"},     {20.0, moved.number, "0.7"}, {20.0, reach, "1"}};
  ChangingSimulation steered{make, {}, &person};
  steered.run_until(100.0);
  REQUIRE(person.refusals.size() == 2);
  CHECK(person.refusals[1].starts_with(tag + " = 7: must be given to a new run"));
  std::vector<Change> rows;
  for (const auto& row : person.rows) rows.push_back({row.time_s, row.number, row.value + " for " + row.before});
  CHECK(rows == std::vector<Change>{{20.0, reach, "0.5 for 1"},
                                    {20.0, reach, "0.4 for 0.5"},
                                    {20.0, moved.number, "0.7 for 0.05"},
                                    {20.0, reach, "1 for 0.4"}});
  std::vector<Change> schedule;
  for (const auto& row : person.rows) schedule.push_back({row.time_s, row.number, row.value});
  ChangingSimulation again{make, schedule};
  again.run_until(100.0);
  CHECK(state_of(again) == state_of(steered));
  const std::string bytes = state_of(again);
  ChangingSimulation resumed{make, schedule};
  Archive archive{bytes};
  CHECK_NOTHROW(resumed.persist(archive));
}

TEST_CASE("changing ecology: conductor that ends the run -> stops there") {
  Person person;
  person.ends_at_s = 20.0;
  ChangingSimulation steered{make, {}, &person};
  steered.run_until(100.0);
  CHECK(steered.time_s() == 20.0);
}
