// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/temporary_folder.hpp>
#include <tools/plan/plan_file.hpp>
#include <tuple>
#include <vector>

namespace {

using namespace trophic;
using plan::PlannedRun;

/// Three runs and the shadow of the third.
std::string small_plan() {
  const auto line = [](const std::string& null, const std::string& folder) {
    return R"({"cell":0,"rule_table":"paper","engine":"kinematic","settings":{"rules.capture.reach_m":0.5,"a.switch":true},)"
           R"("seed":9007199254740991,"null":")" +
           null + R"(","folder":")" + folder +
           R"(","replay_hz":0.0,"agents_every":1,"senses":false,"states":true,"until_s":6000.0,"work":180000.0,)"
           R"("fingerprint":"f0"})"
           "\n";
  };
  return line("none", "cell-0/replicate-0") + line("none", "cell-1/replicate-0") + line("none", "cell-2/replicate-0") +
         line("shadow", "cell-2/shadow/replicate-0");
}

class PlanOnDisk : public test::TemporaryFolder {
 public:
  [[nodiscard]] std::vector<PlannedRun> read(const std::string& text, plan::Lines lines = plan::Lines::described) const {
    return plan::read_plan(file("plan.jsonl", text), lines);
  }
  /// The reader's error, without the folder.
  [[nodiscard]] std::string refused(const std::string& text) const {
    const std::string message = test::message_of<std::invalid_argument>([&] { static_cast<void>(read(text)); });
    return message.empty() ? "" : message.substr(path().string().size() + 1);
  }
};

/// The plan with some `what` of its third line replaced.
std::string with(const std::string& what, const std::string& by) {
  std::string text = small_plan();
  std::size_t line = 0;
  for (int i = 0; i < 2; ++i) line = text.find('\n', line) + 1;
  return text.replace(text.find(what, line), what.size(), by);
}

}  // namespace

TEST_CASE("plan file: its lines -> the runs, field by field") {
  const PlanOnDisk disk;
  const auto runs = disk.read(small_plan());
  REQUIRE(runs.size() == 4);
  const PlannedRun& run = runs[3];
  CHECK(run.rule_table == "paper");
  CHECK(run.engine == "kinematic");
  CHECK(run.settings["rules.capture.reach_m"] == Json(0.5));
  CHECK(run.seed == 9007199254740991);
  CHECK(run.null == Null::shadow);
  CHECK(runs[2].null == Null::none);
  CHECK(disk.read(with("\"none\"", "\"one_sided_big_prey\""))[2].null == Null{Null::one_sided, "big_prey"});
  CHECK(run.folder == "cell-2/shadow/replicate-0");
  CHECK(run.output == io::OutputOptions{.replay_hz = 0.0, .states = true});
  CHECK(run.until_s == 6000.0);
  CHECK(run.work == 180000.0);
  CHECK(run.fingerprint == "f0");
}

TEST_CASE("plan file: a draft -> needs neither what a program says of it nor table and engine") {
  const PlanOnDisk disk;
  const std::string draft = R"({"settings":{},"seed":1,"null":"none","folder":"a","replay_hz":0,"agents_every":1,)"
                            R"("senses":false,"states":false})";
  CHECK(disk.read(draft, plan::Lines::drafts).front().rule_table.empty());
  CHECK(disk.refused(draft) == "plan.jsonl:1: rule_table: is missing");
}

TEST_CASE("plan file: broken -> refused with line, field, value and bound") {
  const PlanOnDisk disk;
  for (const auto& [what, by, message] : {
           std::tuple{"{\"cell\"", "\"cell\"", "plan.jsonl:3: must be a JSON object"},
           std::tuple{"\"seed\"", "\"sede\"", "plan.jsonl:3: sede = 9007199254740991: must be omitted"},
           std::tuple{"\"null\":\"none\",", "", "plan.jsonl:3: null: is missing"},
           std::tuple{"\"none\"", "\"non\"",
                      "plan.jsonl:3: null = \"non\": must be none, shadow, neutral, clones or one_sided_SPECIES"},
           std::tuple{"\"none\"", "\"one_sided_\"", "plan.jsonl:3: null = \"one_sided_\": must be none"},
           std::tuple{"\"rule_table\":\"paper\"", "\"rule_table\":\"\"", "plan.jsonl:3: rule_table = \"\": must be a text"},
           std::tuple{"true}", "null}", "must have a number, a text, true or false at each path"},
           std::tuple{"\"seed\":9007199254740991", "\"seed\":1.5", "plan.jsonl:3: seed = 1.5: must be a whole number >= 0"},
           std::tuple{"6000.0", "0", "plan.jsonl:3: until_s = 0: must be > 0"},
           std::tuple{"6000.0", "\"long\"", "plan.jsonl:3: until_s = \"long\": must be a number"},
           std::tuple{"180000.0", "-1", "plan.jsonl:3: work = -1: must be >= 0"},
           std::tuple{"\"replay_hz\":0.0", "\"replay_hz\":-5.0", "plan.jsonl:3: replay_hz = -5.0: must be >= 0"},
           std::tuple{"\"agents_every\":1", "\"agents_every\":0", "plan.jsonl:3: agents_every = 0: must be >= 1 and <= 9"},
           std::tuple{"cell-2/replicate-0", "../replicate-0",
                      "plan.jsonl:3: folder = \"../replicate-0\": must be a folder within"},
           std::tuple{"cell-2/replicate-0", "a/../../b", "must be a folder within"},
           std::tuple{"cell-2/replicate-0", "/tmp", "must be a folder within"},
           std::tuple{"cell-2/replicate-0", ".", "must be a folder within"},
           std::tuple{"cell-2/replicate-0", "cell-0/replicate-0",
                      "plan.jsonl:3: folder = \"cell-0/replicate-0\": must be unique"},
       }) {
    CAPTURE(by);
    CHECK(disk.refused(with(what, by)).find(message) != std::string::npos);
  }
  CHECK(disk.refused("") == "plan.jsonl: must list at least one run");
  CHECK(disk.refused("\n").starts_with("plan.jsonl:1: must be a JSON object"));
  CHECK_THROWS_WITH_AS(static_cast<void>(plan::read_plan(disk.path() / "none")), doctest::Contains("cannot be read"),
                       std::invalid_argument);
}
