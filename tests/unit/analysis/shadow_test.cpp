// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <support/temporary_folder.hpp>
#include <trophic/analysis/metrics/shadow.hpp>
#include <unit/analysis/run_files.hpp>
#include <vector>

namespace {

using namespace trophic;
using analysis::read_shadowed_set;
using test::message_of;
using test::TemporaryFolder;
using Paths = std::vector<std::filesystem::path>;

/// A run of a table with the rule `heredity`; its floor has the number `floor`.
std::filesystem::path run_of(const std::filesystem::path& folder, const std::string& heredity, int floor = 7, int seed = 1,
                             const std::string& status = "complete") {
  std::string text = test::manifest(heredity, seed);
  text.replace(text.find("complete"), 8, status);
  return test::write_run(folder, text.substr(0, text.size() - 1) + R"(, "rules": {"heredity": ")" + heredity +
                                     R"(", "floor": "victim_floor"}, "numbers": {"seed": )" + std::to_string(seed) +
                                     R"(, "rules": {"floor": {"floor": )" + std::to_string(floor) + "}}}}");
}

}  // namespace

TEST_CASE("the shadow in the runs' folder is found, another one can be named") {
  const TemporaryFolder folder;
  const auto run = run_of(folder.path() / "run", "copy");
  CHECK_FALSE(read_shadowed_set(Paths{run}).shadow);
  CHECK(read_shadowed_set(Paths{run}).shadow_runs().empty());
  run_of(run / "shadow", "nothing_inherited", 7, 1);
  const auto set = read_shadowed_set(Paths{run});
  REQUIRE(set.shadow);
  CHECK(set.shadow_runs().size() == 1);
  CHECK(set.ours.facts.front().folder == run);
  const auto other = run_of(folder.path() / "other", "nothing_inherited", 7, 9);
  CHECK(read_shadowed_set(Paths{run}, other).shadow->facts.front().seed == 9);
}

TEST_CASE("what is no shadow is refused with what differs") {
  const TemporaryFolder folder;
  const auto run = run_of(folder.path() / "run", "copy");
  const auto refusal = [&](const std::filesystem::path& shadow) {
    return message_of<std::invalid_argument>([&] { static_cast<void>(read_shadowed_set(Paths{run}, shadow)); });
  };
  const std::string from = ": is no neutral shadow of " + run.string() + ": ";
  const auto same = run_of(folder.path() / "same", "copy", 7, 2);
  CHECK(refusal(same) == same.string() + from + "its rule in slot heredity is copy: must be nothing_inherited");
  const auto floor = run_of(folder.path() / "floor", "nothing_inherited", 6);
  CHECK(refusal(floor) == floor.string() + from + "numbers/rules/floor/floor = 6: must be 7");
  const auto stopped = run_of(folder.path() / "stopped", "nothing_inherited", 7, 1, "stopped");
  CHECK(refusal(stopped) == stopped.string() + from + "it is stopped at 6000 s: must be complete at 6000 s");
  const auto bare = test::write_run(folder.path() / "bare", test::manifest("cc", 3));
  CHECK(refusal(bare).find("slot heredity is unknown") != std::string::npos);
}

TEST_CASE("both are cut alike") {
  const TemporaryFolder folder;
  const auto run = run_of(folder.path() / "run", "copy");
  run_of(run / "shadow", "nothing_inherited");
  const auto set = read_shadowed_set(Paths{run}, {}, 1.0);
  CHECK(set.ours.facts.front().until_s == 1.0);
  CHECK(set.shadow->facts.front().until_s == 1.0);
}
