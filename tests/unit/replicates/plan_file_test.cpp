// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cstddef>
#include <cstdint>
#include <support/temporary_folder.hpp>
#include <tools/sweep/plan_file.hpp>
#include <tuple>
#include <utility>
#include <vector>

namespace {

using namespace trophic;
using sweep::PlannedRun;

/// Two cells, each of two replicates with shadows.
std::vector<PlannedRun> small_plan() {
  std::vector<PlannedRun> runs;
  for (const bool shadow : {false, true}) {
    for (std::size_t cell = 0; cell < 2; ++cell) {
      for (std::size_t replicate = 0; replicate < 2; ++replicate) {
        PlannedRun run;
        run.index = runs.size();
        run.cell = cell;
        run.replicate = replicate;
        run.shadow = shadow;
        run.rule_table = "paper";
        run.engine = "kinematic";
        run.settings = {{"rules.capture.reach_m", cell == 0 ? 0.5 : 0.75}, {"ecology.robot", "spider"}, {"a.switch", true}};
        run.seed = (std::uint64_t{1} << 53U) - 1 - replicate;
        run.until_s = 6000.0;
        run.work = 180000.0;
        run.folder = "cell-" + std::to_string(cell) + (shadow ? "/shadow" : "") + "/replicate-" + std::to_string(replicate);
        run.fingerprint = std::string{"f"} + std::to_string(cell) + (shadow ? "s" : "o");
        runs.push_back(std::move(run));
      }
    }
  }
  return runs;
}

class PlanOnDisk : public test::TemporaryFolder {
 public:
  [[nodiscard]] std::vector<PlannedRun> read(const std::string& text) const { return sweep::read_plan(file("plan.jsonl", text)); }
  /// The reader's error, without the folder.
  [[nodiscard]] std::string refused(const std::string& text) const {
    const std::string message = test::message_of<std::invalid_argument>([&] { static_cast<void>(read(text)); });
    return message.empty() ? "" : message.substr(path().string().size() + 1);
  }
};

/// The plan with some `what` of its third line replaced.
std::string with(const std::string& what, const std::string& by) {
  std::string text = sweep::plan_text(small_plan());
  std::size_t line = 0;
  for (int i = 0; i < 2; ++i) line = text.find('\n', line) + 1;
  return text.replace(text.find(what, line), what.size(), by);
}

}  // namespace

TEST_CASE("plan file: written -> reads back") {
  const PlanOnDisk disk;
  const auto runs = small_plan();
  const auto read = disk.read(sweep::plan_text(runs));
  REQUIRE(read.size() == runs.size());
  CHECK(sweep::plan_text(read) == sweep::plan_text(runs));
  CHECK(read[6].folder == "cell-1/shadow/replicate-0");
  CHECK(read[6].shadow);
  CHECK(read[6].seed == 9007199254740991);
  CHECK(read[6].settings.begin().key() == "rules.capture.reach_m");
  CHECK(read[6].settings["rules.capture.reach_m"] == Json(0.75));
}

TEST_CASE("plan file: broken -> refused with line, field, value and bound") {
  const PlanOnDisk disk;
  for (const auto& [what, by, message] : {
           std::tuple{"{\"index\":2", "{\"index\":3", "plan.jsonl:3: index = 3: must be 2"},
           std::tuple{"{\"index\":2", "{\"index\":-2", "plan.jsonl:3: index = -2: must be a whole number >= 0"},
           std::tuple{"{\"index\":2", "\"index\":2", "plan.jsonl:3: must be a JSON object"},
           std::tuple{"\"cell\":1,", "", "plan.jsonl:3: cell: must be there"},
           std::tuple{"\"cell\":1", "\"cell\":0", "plan.jsonl:3: replicate = 0: must be another for each run of cell 0"},
           std::tuple{"\"shadow\":false", "\"shadow\":0", "plan.jsonl:3: shadow = 0: must be true or false"},
           std::tuple{"\"rule_table\":\"paper\"", "\"rule_table\":\"\"", "plan.jsonl:3: rule_table = \"\": must be a text"},
           std::tuple{"true}", "null}", "must have a number, a text, true or false at each path"},
           std::tuple{"\"seed\":9007199254740991", "\"seed\":1.5", "plan.jsonl:3: seed = 1.5: must be a whole number >= 0"},
           std::tuple{"6000.0", "0", "plan.jsonl:3: until_s = 0: must be > 0"},
           std::tuple{"6000.0", "\"long\"", "plan.jsonl:3: until_s = \"long\": must be a number"},
           std::tuple{"180000.0", "-1", "plan.jsonl:3: work = -1: must be >= 0"},
           std::tuple{"\"replay_hz\":0.0", "\"replay_hz\":-5.0", "plan.jsonl:3: replay_hz = -5.0: must be >= 0"},
           std::tuple{"\"agents_every\":1", "\"agents_every\":0", "plan.jsonl:3: agents_every = 0: must be >= 1 and <= 9"},
           std::tuple{"cell-1/replicate-0", "../replicate-0",
                      "plan.jsonl:3: folder = \"../replicate-0\": must be a folder within"},
           std::tuple{"cell-1/replicate-0", "a/../../b", "must be a folder within"},
           std::tuple{"cell-1/replicate-0", "/tmp", "must be a folder within"},
           std::tuple{"cell-1/replicate-0", ".", "must be a folder within"},
           std::tuple{"cell-1/replicate-0", "cell-0/replicate-0",
                      "plan.jsonl:3: folder = \"cell-0/replicate-0\": must be another"},
       }) {
    CAPTURE(by);
    CHECK(disk.refused(with(what, by)).find(message) != std::string::npos);
  }
  CHECK(disk.refused("") == "plan.jsonl: must list a run");
  CHECK(disk.refused("\n").starts_with("plan.jsonl:1: must be a JSON object"));
  CHECK_THROWS_WITH_AS(static_cast<void>(sweep::read_plan(disk.path() / "none")), doctest::Contains("cannot be read"),
                       std::invalid_argument);
}

TEST_CASE("plan file: runs of a cell -> those of this cell alone") {
  const PlanOnDisk disk;
  const auto refused = [&](auto change) {
    auto runs = small_plan();
    change(runs);
    return disk.refused(sweep::plan_text(runs));
  };
  CHECK(refused([](auto& runs) { runs[1].seed = runs[0].seed; }) ==
        "plan.jsonl:2: seed = 9007199254740991: must be another for each replicate of cell 0");
  CHECK(refused([](auto& runs) { runs[4].seed = 5; }) ==
        "plan.jsonl:5: seed = 5: must be 9007199254740991, as a replicate and its shadow have one");
  CHECK(refused([](auto& runs) { runs[1].engine = "ode"; }) ==
        "plan.jsonl:2: engine = \"ode\": must be \"kinematic\", as in the other runs of cell 0");
  CHECK(refused([](auto& runs) {
          runs[4].rule_table = "released";
        }).starts_with("plan.jsonl:5: rule_table = \"released\": must be"));
  CHECK(refused([](auto& runs) { runs[3].settings["a.switch"] = false; }).starts_with("plan.jsonl:4: settings = {"));
  CHECK(refused([](auto& runs) { runs[7].until_s = 5.0; }) ==
        "plan.jsonl:8: until_s = 5.0: must be 6000.0, as in the other runs of cell 1");
  CHECK(refused([](auto& runs) { runs[6].output.agents_every_ticks = 3; }) ==
        "plan.jsonl:7: agents_every = 3: must be 1, as in the other runs of cell 1");
  CHECK(refused([](auto& runs) { runs[7].output.senses = true; }) ==
        "plan.jsonl:8: senses = true: must be false, as in the other runs of cell 1");
  CHECK(refused([](auto& runs) { runs[7].output.states = true; }) ==
        "plan.jsonl:8: states = true: must be false, as in the other runs of cell 1");
  CHECK(refused([](auto& runs) { runs[7].output.replay_hz = 5.0; }) ==
        "plan.jsonl:8: replay_hz = 5.0: must be 0.0, as in the other runs of cell 1");
  CHECK(refused([](auto& runs) { runs[7].fingerprint = "f0o"; }) ==
        "plan.jsonl:8: fingerprint = \"f0o\": must be \"f1s\", as in the other runs of cell 1");
}
