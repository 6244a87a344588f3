// SPDX-License-Identifier: MIT
// One run of a plan: made once, resumed, never written by two programs, and its stage as its folders have it.
#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <support/temporary_folder.hpp>
#include <thread>
#include <tools/plan/make_run.hpp>
#include <trophic/io/growing_file.hpp>
#include <trophic/io/program_code.hpp>
#include <trophic/run/checkpoint/checkpoint_file.hpp>
#include <trophic/support/checksum.hpp>
#include <trophic/support/version.hpp>
#include <vector>

using namespace trophic;
using plan::PlannedRun;
using plan::Stage;
using test::TemporaryFolder;

namespace {

namespace fs = std::filesystem;

std::vector<PlannedRun> plan_of(std::size_t count) {
  std::vector<PlannedRun> plan;
  for (std::size_t i = 0; i < count; ++i) {
    PlannedRun run;
    run.seed = 7;
    run.rule_table = "paper";
    run.engine = "kinematic";
    run.settings["rules.x"] = i;
    run.until_s = 1.0;
    run.folder = "cell-" + std::to_string(i) + "/replicate-00";
    run.fingerprint = std::string(15, '0') + std::to_string(i);
    plan.push_back(run);
  }
  return plan;
}

/// What a run leaves that ended so.
void leave(const fs::path& folder, const std::string& status, const PlannedRun& run, const std::string& code = "") {
  fs::create_directories(folder);
  std::ofstream{folder / "events.csv"} << "time_s\n";
  std::ofstream{folder / "manifest.json"} << R"({"status": ")" << status << R"(", "fingerprint": ")" << run.fingerprint
                                          << R"(", "seed": )" << run.seed << R"(, "clock": {"until_s": )" << run.until_s
                                          << R"(}, "tables": {"events.csv": {"rows": 0, "crc32": )" << checksum("time_s\n")
                                          << R"(}}, "code": ")" << code << "\"}\n";
}

void leave_checkpoint(const fs::path& folder) {
  checkpoint::write(folder, {.fingerprint = "", .program_version = std::string{version}, .sections = {}});
}

struct OneRun {
  TemporaryFolder disk;
  PlannedRun run = plan_of(1).front();
  fs::path folder = disk.path() / run.folder;
  fs::path lock = folder.string() + ".lock";

  [[nodiscard]] Stage stage() const { return plan::stage_of(disk.path(), run); }
  /// The error of an attempt to make it; empty if it is complete.
  [[nodiscard]] std::string make(const std::function<void(const fs::path&)>& work) const {
    return test::message_of<std::exception>([&] { plan::make_run(disk.path(), run, work); });
  }
  [[nodiscard]] std::string make() const {
    return make([&](const fs::path& own) { leave(own, "complete", run); });
  }
};

void never(const fs::path&) {
  FAIL("worked");
}

}  // namespace

TEST_CASE("planned run: complete -> gets its name, leaves nothing else and is not made again") {
  const OneRun one;
  CHECK(one.stage() == Stage::missing);
  CHECK(one.make([&](const fs::path& own) {
    CHECK(own == one.folder);
    CHECK_FALSE(fs::exists(own));
    CHECK(one.stage() == Stage::running);
    leave(own, "complete", one.run);
  }) == "");
  CHECK(one.stage() == Stage::complete);
  CHECK(std::distance(fs::directory_iterator{one.folder.parent_path()}, {}) == 1);
  CHECK(one.make(never) == "");
}

TEST_CASE("planned run: many threads make one at once -> one works, and the others say why not or find it complete") {
  for (int i = 0; i < 20; ++i) {
    const OneRun one;
    std::atomic<int> worked = 0;
    std::atomic<int> unexplained = 0;
    {
      std::vector<std::jthread> threads;
      for (int thread = 0; thread < 8; ++thread) {
        threads.emplace_back([&] {
          const std::string why = one.make([&](const fs::path& own) {
            ++worked;
            leave(own, "complete", one.run);
          });
          if (!why.empty() && why != "another program is running it") ++unexplained;
        });
      }
    }
    CHECK(worked == 1);
    CHECK(unexplained == 0);
    CHECK(one.stage() == Stage::complete);
  }
}

TEST_CASE("planned run: another program makes it -> refused until that program dies, and resumed from its checkpoint") {
  const OneRun one;
  int began[2];
  REQUIRE(::pipe(began) == 0);
  const pid_t child = ::fork();
  if (child == 0) {
    plan::make_run(one.disk.path(), one.run, [&](const fs::path& own) {
      leave(own, "running", one.run);
      leave_checkpoint(own);
      static_cast<void>(::write(began[1], "1", 1));
      ::pause();
    });
    ::_exit(1);
  }
  char byte = 0;
  REQUIRE(::read(began[0], &byte, 1) == 1);
  CHECK(one.stage() == Stage::running);
  CHECK(one.make(never) == "another program is running it");
  REQUIRE(::kill(child, SIGKILL) == 0);
  REQUIRE(::waitpid(child, nullptr, 0) == child);
  CHECK(one.stage() == Stage::interrupted);
  CHECK(one.make([&](const fs::path& own) {
    CHECK(checkpoint::exists(own));
    leave(own, "complete", one.run);
  }) == "");
  CHECK_FALSE(fs::exists(one.lock));
}

TEST_CASE("planned run: ended by a signal or an error -> interrupted or failed, and made again") {
  const OneRun one;
  CHECK(one.make([&](const fs::path& own) { leave(own, "stopped", one.run); }) == "status \"stopped\"");
  CHECK(one.stage() == Stage::interrupted);
  CHECK(one.make([&](const fs::path& own) {
    leave(own, "failed", one.run);
    throw std::runtime_error{"diverged"};
  }) == "diverged");
  CHECK(one.stage() == Stage::failed);
  CHECK(one.make() == "");
}

TEST_CASE("planned run: killed between its end and its lock's end -> not made again") {
  const OneRun one;
  leave(one.folder, "complete", one.run);
  std::ofstream{one.lock};
  CHECK(one.stage() == Stage::complete);
  CHECK(one.make(never) == "");
  CHECK_FALSE(fs::exists(one.lock));
}

TEST_CASE("planned run: files that do not fit their checkpoint -> set aside, and the next attempt begins without them") {
  const OneRun one;
  leave(one.folder, "running", one.run);
  leave_checkpoint(one.folder);
  CHECK(one.make([](const fs::path&) { throw DamagedFile{"events.csv: other bytes"}; }) ==
        "events.csv: other bytes; kept as " + one.folder.string() + ".incomplete-1; the next attempt starts without it");
  CHECK(fs::exists(one.folder.string() + ".incomplete-1/events.csv"));
  CHECK(one.make() == "");
}

TEST_CASE("planned run: another run in the run's folder, or damaged files -> not complete, and made again") {
  const OneRun one;
  PlannedRun other = plan_of(2)[1];
  const auto check = [&] {
    leave(one.folder, "complete", other);
    CHECK(one.stage() != Stage::complete);
    bool worked = false;
    static_cast<void>(one.make([&](const fs::path&) { worked = true; }));
    CHECK(worked);
    other = one.run;
  };
  check();
  other.seed = 8;
  check();
  other.until_s = 2.0;
  check();
  leave(one.folder, "complete", one.run);
  CHECK(one.make(never) == "");
  std::ofstream{one.folder / "events.csv"} << "time_S\n";
  CHECK(one.stage() == Stage::failed);
  CHECK(plan::stage_of(one.disk.path(), one.run, false) == Stage::complete);
  CHECK_NOTHROW(plan::make_run(one.disk.path(), one.run, never, false));
  CHECK(one.make() == "");
  CHECK(one.stage() == Stage::complete);
}

TEST_CASE("planned run: a link on its way -> refused, and nothing is written where it leads") {
  const OneRun one;
  const TemporaryFolder elsewhere;
  for (const fs::path& link : {one.folder.parent_path(), one.folder, one.lock}) {
    CAPTURE(link);
    fs::create_directory_symlink(elsewhere.path(), link);
    CHECK(one.make(never).starts_with(link.string() + ": is a symbolic link"));
    fs::remove(link);
    fs::create_directories(one.folder.parent_path());
  }
  CHECK(fs::is_empty(elsewhere.path()));
}

TEST_CASE("plan: a part made by another build -> refused while there is more to do") {
  const TemporaryFolder folder;
  const auto plan = plan_of(2);
  leave(folder.path() / plan[0].folder, "complete", plan[0], program_code());
  CHECK_NOTHROW(plan::check_builds(folder.path(), plan));
  leave(folder.path() / plan[0].folder, "complete", plan[0], "another");
  CHECK(test::message_of<std::invalid_argument>([&] {
          plan::check_builds(folder.path(), plan);
        }).find("code = another: must be " + program_code()) != std::string::npos);
  leave(folder.path() / plan[1].folder, "complete", plan[1], program_code());
  CHECK_NOTHROW(plan::check_builds(folder.path(), plan));
}
