// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <string>
#include <trophic/observe/run_description.hpp>
#include <unit/observe/scene.hpp>

using namespace trophic;

TEST_CASE("fingerprint: another seed, duration or table name -> the same, and any other change -> another") {
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
