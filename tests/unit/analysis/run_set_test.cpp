// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/temporary_folder.hpp>
#include <tools/analysis/metrics/run_set.hpp>
#include <unit/reading/run_files.hpp>

namespace {

using namespace trophic;
using analysis::read_set;
using analysis::read_shadowed_set;
using test::manifest;
using test::message_of;
using test::run_of;
using test::TemporaryFolder;
using test::write_run;
using Paths = std::vector<std::filesystem::path>;

}  // namespace

TEST_CASE("runs of different status or duration are not pooled, unless all are cut to what they have") {
  const TemporaryFolder folder;
  const auto with_end = [](int seed, const std::string& status, double reached_s) {
    std::string text = manifest("aa", seed);
    text.replace(text.find("complete"), 8, status);
    return text.substr(0, text.size() - 1) + R"(, "result": {"reached_s": )" + std::to_string(reached_s) + "}}";
  };
  const auto a = write_run(folder.path() / "a", with_end(1, "complete", 6000.0));
  const auto b = write_run(folder.path() / "b", with_end(2, "stopped", 100.0));
  const auto c = write_run(folder.path() / "c", with_end(3, "stopped", 200.0));
  CHECK(
      message_of<std::invalid_argument>([&] {
        static_cast<void>(read_set(Paths{a, b}));
      }) ==
      b.string() + ": status \"stopped\" at 100 of 6000 s, but " + a.string() +
          " has status \"complete\" at 6000 of 6000 s; runs of different length are not pooled: leave some out, or cut all with "
          "--until");
  CHECK(message_of<std::invalid_argument>([&] {
          static_cast<void>(read_set(Paths{b, c}));
        }).find("at 200 of 6000 s, but ") != std::string::npos);
  const auto killed = [&](const std::string& name, int seed) {
    std::string text = manifest("aa", seed);
    return write_run(folder.path() / name, text.replace(text.find("complete"), 8, "running"));
  };
  const auto d = killed("d", 4);
  CHECK(message_of<std::invalid_argument>([&] {
          static_cast<void>(read_set(Paths{d, killed("e", 5)}));
        }).find("status \"running\" at an unknown time of 6000 s; runs of different length are not pooled") != std::string::npos);
  CHECK(read_set(Paths{d}).runs.size() == 1);
  CHECK(read_set(Paths{a, b, c}, {.until_s = 100.0}).runs.size() == 3);
  CHECK(read_set(Paths{a, b, c}, {.until_s = 100.0}).manifests[1].until_s == 100.0);
  CHECK(message_of<std::invalid_argument>([&] {
          static_cast<void>(read_set(Paths{a, b, c}, {.until_s = 150.0}));
        }).starts_with(b.string()));
}

TEST_CASE("read_set: a run without manifest or table among others -> error, no numbers of the others") {
  const TemporaryFolder folder;
  const auto good = write_run(folder.path() / "good", manifest("aa", 1));
  const auto bare = write_run(folder.path() / "bare", manifest("aa", 2));
  const auto broken = write_run(folder.path() / "broken", manifest("aa", 3));
  std::filesystem::remove(bare / "manifest.json");
  std::filesystem::remove(broken / "agents.csv");
  const auto refusal = [&](const auto& paths) {
    return message_of<std::invalid_argument>([&] { static_cast<void>(read_set(paths)); });
  };
  CHECK(refusal(Paths{good}).empty());
  CHECK(refusal(Paths{good, bare}).starts_with((bare / "manifest.json").string() + ": cannot be read: "));
  CHECK(refusal(Paths{good, broken}).starts_with((broken / "agents.csv").string() + ": cannot be read: "));
  const auto none = folder.path() / "none";
  CHECK(message_of<std::invalid_argument>([&] { static_cast<void>(read_set(Paths{none})); }) ==
        none.string() + ": does not exist");
}

TEST_CASE("the shadow in the runs' folder is found, another one can be named") {
  const TemporaryFolder folder;
  const auto run = run_of(folder.path() / "run", "copy");
  CHECK_FALSE(read_shadowed_set(Paths{run}).shadow);
  CHECK(read_shadowed_set(Paths{run}).shadow_runs().empty());
  run_of(run / "shadow", "nothing_inherited", 7, 1);
  const auto set = read_shadowed_set(Paths{run});
  REQUIRE(set.shadow);
  CHECK(set.shadow_runs().size() == 1);
  CHECK(set.ours.manifests.front().folder == run);
  const auto other = run_of(folder.path() / "other", "nothing_inherited", 7, 9);
  CHECK(read_shadowed_set(Paths{run}, other).shadow->manifests.front().seed == 9);
}

TEST_CASE("run set: cut in time -> runs and shadow are cut alike") {
  const TemporaryFolder folder;
  const auto run = run_of(folder.path() / "run", "copy");
  run_of(run / "shadow", "nothing_inherited");
  const auto set = read_shadowed_set(Paths{run}, {}, {.until_s = 1.0});
  CHECK(set.ours.manifests.front().until_s == 1.0);
  CHECK(set.shadow->manifests.front().until_s == 1.0);
}
