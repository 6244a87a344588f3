// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <string>
#include <trophic/observe/run_description.hpp>
#include <unit/observe/scene.hpp>

using namespace trophic;

TEST_CASE("fingerprint: seed, duration and threads -> same, anything else -> different") {
  const observe::RunDescription run = test::short_run();
  const std::string print = observe::fingerprint(run, "models");
  CHECK(print.size() == 16);
  CHECK(print.find_first_not_of("0123456789abcdef") == std::string::npos);
  CHECK(observe::fingerprint(run, "models") == print);

  const auto changed = [&](auto&& change, const std::string& models = "models") {
    observe::RunDescription other = run;
    change(other);
    return observe::fingerprint(other, models) != print;
  };
  CHECK_FALSE(changed([](auto& other) { other.seed = 6; }));
  CHECK_FALSE(changed([](auto& other) { other.until_s = 99.0; }));
  CHECK_FALSE(changed([](auto& other) { other.rules = "another name"; }));  // a table of another name with the same rules
  CHECK(changed([](auto& other) { other.slots[0].second = "victim_floor"; }));
  CHECK(changed([](auto& other) { other.backend = "paper 2"; }));
  CHECK(changed([](auto&) {}, "other models"));
}

namespace {

observe::RunDescription with_changes(std::vector<observe::ParameterChange> changes) {
  observe::RunDescription run = test::short_run();
  run.changes = std::move(changes);
  return run;
}

const observe::ParameterChange reach{10.0, 5, "rules.capture.reach_m", "0.5", "0.3"};
const observe::ParameterChange deviation{12.0, 6, "rules.mutation.sd", "0.1", "0.05"};
const observe::Branch branch{.run = "runs/a", .at_s = "700", .seed = "7", .fingerprint = "fedcba9876543210"};

}  // namespace

TEST_CASE("identity: no effective change -> fingerprint, else -> fingerprint and the same suffix for the same changes") {
  const std::string same = test::short_run().fingerprint;
  CHECK(observe::identity(test::short_run()) == same);
  CHECK(observe::identity(with_changes({{10.0, 5, "rules.a", "1", "1"}})) == same);
  CHECK(observe::identity(with_changes({{10.0, 5, "rules.a", "2", "1"}, {10.0, 5, "rules.a", "1", "2"}})) == same);
  // zlib.crc32(b"5 rules.a=2\n"), as tools/python/trophic/description.py has it
  CHECK(observe::identity(with_changes({{10.0, 5, "rules.a", "2", "1"}})) == same + "+364ab8e5");
  const std::string two = observe::identity(with_changes({reach, {10.0, 5, "rules.a", "2", "1"}}));
  CHECK(two == observe::identity(with_changes({{10.0, 5, "rules.a", "3", "1"}, reach, {10.0, 5, "rules.a", "2", "3"}})));
  CHECK(two != observe::identity(with_changes({reach})));
  observe::RunDescription begun = with_changes({});
  begun.branch = branch;
  CHECK(observe::identity(begun).starts_with(same + "+"));
  CHECK(observe::identity(begun) != observe::identity(with_changes({reach})));
}

TEST_CASE("description: own parameters, changes and branch -> name and sentence with them") {
  observe::RunDescription run = test::short_run();
  CHECK(observe::short_name(run) == "hand_written");
  CHECK(observe::sentence(run) == "rule table `hand_written` and its parameters");
  run.other_params = {{"rules.mutation.sd", "0.125", "0.05"}};
  CHECK(observe::short_name(run) == "hand_written (mutation.sd 0.125)");
  run.changes = {reach};
  run.branch = branch;
  CHECK(observe::short_name(run) == "hand_written (mutation.sd 0.125; capture.reach_m 0.5 at 10 s; from 700 s)");
  CHECK(observe::sentence(run) ==
        "rule table `hand_written` and rules.mutation.sd = 0.125 (the table's: 0.05); at 10 s rules.capture.reach_m changes from "
        "0.3 to 0.5; begins at 700 s of runs/a (seed 7)");
  run.other_params.push_back({"ecology.robots", "60", "30"});
  run.changes = {reach, deviation};
  CHECK(observe::short_name(run) == "hand_written (2 parameters; 2 changes; from 700 s)");
}

TEST_CASE("own parameters: seed, duration, threads and texts that follow from others -> not among them") {
  const NamedParams table{
      {"seed", std::int64_t{1}, ""},   {"ecology.duration_s", 10.0, ""},    {"backend.threads", std::int64_t{1}, ""},
      {"rules.mutation.sd", 0.05, ""}, {"ecology.gait", std::string{}, ""}, {"ecology.robots", std::int64_t{30}, ""}};
  const NamedParams own{
      {"seed", std::int64_t{2}, ""},    {"ecology.duration_s", 20.0, ""},          {"backend.threads", std::int64_t{4}, ""},
      {"rules.mutation.sd", 0.125, ""}, {"ecology.gait", std::string{"trot"}, ""}, {"ecology.robots", std::int64_t{30}, ""}};
  const std::vector<observe::OtherParam> others = observe::other_params(own, table);
  REQUIRE(others.size() == 1);
  CHECK(others[0].path == "rules.mutation.sd");
  CHECK(others[0].value == "0.125");
  CHECK(others[0].table == "0.05");
}
