// SPDX-License-Identifier: MIT
// Claims on runs, attempts at them, and the division of a plan among programs.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <fstream>
#include <iterator>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <tools/sweep/attempt.hpp>
#include <tools/sweep/claim.hpp>
#include <tools/sweep/folder.hpp>
#include <tools/sweep/work_through.hpp>
#include <trophic/io/growing_file.hpp>
#include <trophic/io/program_code.hpp>
#include <trophic/run/checkpoint/checkpoint_file.hpp>
#include <trophic/support/version.hpp>
#include <vector>

#include "../../support/temporary_folder.hpp"

using namespace trophic;
using sweep::Claim;
using sweep::Ended;
using sweep::PlannedRun;
using sweep::Result;
using test::TemporaryFolder;

namespace {

namespace fs = std::filesystem;

constexpr double long_lease_s = 1000.0;

/// A plan of runs with this much work each.
std::vector<PlannedRun> plan_with(const std::vector<double>& works) {
  std::vector<PlannedRun> plan;
  for (const double work : works) {
    PlannedRun run;
    run.index = plan.size();
    run.cell = plan.size();
    run.seed = 7;
    run.rule_table = "paper";
    run.engine = "kinematic";
    run.settings["rules.x"] = plan.size();
    run.until_s = 1.0;
    run.work = work;
    run.folder = "cell-" + std::to_string(plan.size()) + "/replicate-00";
    run.fingerprint = std::string(15, '0') + std::to_string(plan.size());
    plan.push_back(run);
  }
  return plan;
}

/// What a run leaves that ended so.
void leave_manifest(const fs::path& folder, const std::string& status, const PlannedRun& run, const std::string& code = "") {
  fs::create_directories(folder);
  std::ofstream{folder / "events.csv"} << "time_s\n";
  std::ofstream{folder / "manifest.json"} << R"({"status": ")" << status << R"(", "fingerprint": ")" << run.fingerprint
                                          << R"(", "seed": )" << run.seed << R"(, "clock": {"until_s": )" << run.until_s
                                          << R"(}, "tables": {"events.csv": {}}, "code": ")" << code << "\"}\n";
}

void make_old(const fs::path& path, double by_s) {
  struct stat state {};
  REQUIRE(::stat(path.c_str(), &state) == 0);
  timespec then = state.st_mtim;
  then.tv_sec -= static_cast<time_t>(by_s);
  const timespec both[2] = {then, then};
  REQUIRE(::utimensat(AT_FDCWD, path.c_str(), both, 0) == 0);
}

}  // namespace

TEST_CASE("claim: claimed run -> refused until it is given back") {
  const TemporaryFolder folder;
  {
    const auto first = Claim::take(folder.path(), 3, long_lease_s);
    REQUIRE(first);
    CHECK_FALSE(Claim::take(folder.path(), 3, long_lease_s));
    CHECK(Claim::take(folder.path(), 4, long_lease_s));
    CHECK(sweep::claimant_of(folder.path(), 3, long_lease_s).ends_with("(process " + std::to_string(::getpid()) + ")"));
  }
  CHECK(sweep::claimant_of(folder.path(), 3, long_lease_s).empty());
  CHECK(fs::is_empty(folder.path()));
  CHECK(Claim::take(folder.path(), 3, long_lease_s));
}

TEST_CASE("claim: many threads claim one run at once -> one gets it") {
  const TemporaryFolder folder;
  for (std::size_t run = 0; run < 50; ++run) {
    std::atomic<int> got = 0;
    std::mutex mutex;
    std::vector<Claim> claims;
    {
      std::vector<std::jthread> threads;
      for (int i = 0; i < 8; ++i) {
        threads.emplace_back([&] {
          auto claim = Claim::take(folder.path(), run, long_lease_s);
          if (!claim) return;
          ++got;
          const std::scoped_lock lock{mutex};
          claims.push_back(std::move(*claim));
        });
      }
    }
    CHECK(got == 1);
  }
}

TEST_CASE("claim: its program on this machine died -> stale at once") {
  const TemporaryFolder folder;
  const pid_t child = ::fork();
  if (child == 0) {
    // Dies as by SIGKILL: nothing is given back.
    const auto claim = Claim::take(folder.path(), 0, long_lease_s);
    ::_exit(claim ? 0 : 1);
  }
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  REQUIRE(WEXITSTATUS(status) == 0);
  REQUIRE(fs::exists(folder.path() / "0.0"));
  CHECK(sweep::claimant_of(folder.path(), 0, long_lease_s).empty());
  {
    const auto taken_over = Claim::take(folder.path(), 0, long_lease_s);
    CHECK(taken_over);
    CHECK(fs::exists(folder.path() / "0.1"));
    CHECK_FALSE(Claim::take(folder.path(), 0, long_lease_s));
  }
  CHECK(fs::is_empty(folder.path()));
}

TEST_CASE("claim: space of a process -> has this start of the machine, as initial namespaces are alike on all of them") {
  if (!fs::exists("/proc/sys/kernel/random/boot_id")) return;
  std::string boot;
  std::ifstream{"/proc/sys/kernel/random/boot_id"} >> boot;
  REQUIRE(boot.size() == 36);
  const TemporaryFolder folder;
  const auto taken = Claim::take(folder.path(), 3, long_lease_s);
  REQUIRE(taken);
  std::ifstream owner{folder.path() / "3.0" / "owner.json"};
  const std::string text{std::istreambuf_iterator<char>{owner}, {}};
  CHECK(text.find("\"" + boot + " ") != std::string::npos);
}

TEST_CASE("claim: of another machine, not renewed for its lease -> stale") {
  const TemporaryFolder folder;
  const fs::path claim = folder.path() / "5.0";
  fs::create_directory(claim);
  std::ofstream{claim / "owner.json"} << R"({"host": "elsewhere", "process": 1, "space": "another boot"})";
  CHECK_FALSE(Claim::take(folder.path(), 5, 60.0));
  CHECK(sweep::claimant_of(folder.path(), 5, 60.0) == "elsewhere (process 1)");
  make_old(claim / "owner.json", 59.0);
  CHECK_FALSE(Claim::take(folder.path(), 5, 60.0));
  make_old(claim / "owner.json", 62.0);
  CHECK(Claim::take(folder.path(), 5, 60.0));
}

TEST_CASE("claim: renewed in the future by more than its lease -> stale") {
  const TemporaryFolder folder;
  const fs::path claim = folder.path() / "5.0";
  fs::create_directory(claim);
  std::ofstream{claim / "owner.json"} << R"({"host": "elsewhere", "process": 1, "space": "another boot"})";
  make_old(claim / "owner.json", -50.0);
  CHECK_FALSE(Claim::take(folder.path(), 5, 60.0));
  make_old(claim / "owner.json", -1e6);
  CHECK(Claim::take(folder.path(), 5, 60.0));
}

TEST_CASE("claim: a link in the place of its files or their folder -> nothing is written where it leads") {
  const TemporaryFolder folder;
  const TemporaryFolder elsewhere;
  const fs::path claims = folder.path() / "claims";
  fs::create_directory_symlink(elsewhere.path(), claims);
  CHECK(test::message_of<std::invalid_argument>([&] {
          static_cast<void>(Claim::take(claims, 0, 60.0));
        }).starts_with(claims.string() + ": is a symbolic link"));
  CHECK(fs::is_empty(elsewhere.path()));
  fs::remove(claims);
  fs::create_directories(claims);
  fs::create_directory_symlink(elsewhere.path(), claims / "0.0");
  CHECK_FALSE(Claim::take(claims, 0, 60.0));
  CHECK(fs::is_empty(elsewhere.path()));
}

TEST_CASE("sweep attempt: a link on the way to the run, or among its attempts -> a failure, and nothing is written there") {
  const TemporaryFolder folder;
  const TemporaryFolder elsewhere;
  const auto plan = plan_with({1.0});
  const auto failure = [&] {
    const Result result = sweep::attempt(folder.path(), plan[0], long_lease_s, [](const fs::path&) { FAIL("worked"); });
    CHECK(result.ended == Ended::failed);
    return result.text;
  };
  fs::create_directory_symlink(elsewhere.path(), folder.path() / "cell-0");
  CHECK(failure().find("cell-0: is a symbolic link") != std::string::npos);
  fs::remove(folder.path() / "cell-0");
  fs::create_directory(folder.path() / "cell-0");
  fs::create_directory_symlink(elsewhere.path(), folder.path() / "cell-0/replicate-00.attempt-0");
  CHECK(failure().find("replicate-00.attempt-0: is a symbolic link") != std::string::npos);
  CHECK(fs::is_empty(elsewhere.path()));
}

TEST_CASE("sweep attempt: another run, or one without its tables, in the run's folder -> not complete, and a failure") {
  const TemporaryFolder folder;
  const auto plan = plan_with({1.0, 1.0});
  const fs::path run = folder.path() / plan[0].folder;
  const auto failure = [&] {
    CHECK_FALSE(sweep::is_complete(folder.path(), plan[0]));
    return sweep::attempt(folder.path(), plan[0], long_lease_s, [](const fs::path&) { FAIL("worked"); }).text;
  };
  leave_manifest(run, "complete", plan[1]);
  CHECK(failure() == run.string() + ": holds something else than the complete run that was planned: move it away");
  PlannedRun other = plan[0];
  other.seed = 8;
  leave_manifest(run, "complete", other);
  CHECK_FALSE(failure().empty());
  other = plan[0];
  other.until_s = 0.5;
  leave_manifest(run, "complete", other);
  CHECK_FALSE(failure().empty());
  leave_manifest(run, "complete", plan[0]);
  CHECK(sweep::is_complete(folder.path(), plan[0]));
  fs::remove(run / "events.csv");
  CHECK_FALSE(failure().empty());
  fs::remove(run / "manifest.json");
  CHECK(sweep::attempt(folder.path(), plan[0], long_lease_s, [&](const fs::path& own) {
          leave_manifest(own, "complete", plan[0]);
        }).ended == Ended::complete);
}

TEST_CASE("sweep attempt: an older attempt whose files are damaged -> set aside, and the next begins without it") {
  const TemporaryFolder folder;
  const auto plan = plan_with({1.0});
  const fs::path old = folder.path() / (plan[0].folder.string() + ".attempt-0");
  leave_manifest(old, "running", plan[0]);
  checkpoint::write(old, {.fingerprint = "", .program_version = std::string{version}, .sections = {}});
  const Result result =
      sweep::attempt(folder.path(), plan[0], long_lease_s, [](const fs::path&) { throw DamagedFile{"events.csv: other bytes"}; });
  CHECK(result.ended == Ended::failed);
  CHECK(result.text.find("other bytes; kept as " + old.string() + ".incomplete-1") != std::string::npos);
  CHECK(fs::exists(old.string() + ".incomplete-1/events.csv"));
  const Result next = sweep::attempt(folder.path(), plan[0], long_lease_s, [&](const fs::path& own) {
    CHECK_FALSE(fs::exists(own));
    leave_manifest(own, "complete", plan[0]);
  });
  CHECK(next.ended == Ended::complete);
}

TEST_CASE("sweep: a part made by another build -> refused while there is more to do") {
  const TemporaryFolder folder;
  const auto plan = plan_with({1.0, 1.0});
  leave_manifest(folder.path() / plan[0].folder, "complete", plan[0], program_code());
  CHECK_NOTHROW(sweep::check_builds(folder.path(), plan));
  leave_manifest(folder.path() / plan[0].folder, "complete", plan[0], "another");
  CHECK(test::message_of<std::invalid_argument>([&] {
          sweep::check_builds(folder.path(), plan);
        }).find("code = another: must be " + program_code()) != std::string::npos);
  leave_manifest(folder.path() / plan[1].folder, "complete", plan[1], program_code());
  CHECK_NOTHROW(sweep::check_builds(folder.path(), plan));
}

TEST_CASE("A claim without an owner's file is as old as its folder") {
  const TemporaryFolder folder;
  const fs::path claim = folder.path() / "5.0";
  fs::create_directory(claim);
  CHECK_FALSE(Claim::take(folder.path(), 5, 60.0));
  make_old(claim, 62.0);
  CHECK(Claim::take(folder.path(), 5, 60.0));
}

TEST_CASE("claim: other programs remove the empty folder of claims meanwhile -> the run is claimed") {
  const TemporaryFolder folder;
  const std::vector<PlannedRun> plan = plan_with({1.0});
  std::atomic<bool> is_over = false;
  std::jthread others{[&] {
    while (!is_over) sweep::remove_claims(folder.path(), plan);
  }};
  std::string failure;
  int taken = 0;
  for (int i = 0; i < 500; ++i) {
    try {
      if (Claim::take(folder.path() / sweep::claims_name, 0, long_lease_s)) ++taken;
    } catch (const std::exception& error) {
      failure = error.what();
    }
  }
  is_over = true;
  CHECK(failure == "");
  CHECK(taken == 500);
}

TEST_CASE("claim: owner's file of another format -> another program's claim until its lease is over") {
  const TemporaryFolder folder;
  const fs::path claim = folder.path() / "5.0";
  fs::create_directory(claim);
  for (const char* text :
       {"", "[1]", "{\"process\": 1}", R"({"host": "h", "process": "1", "space": "s"})",
        R"({"host": 1, "process": 1, "space": "s"})", R"({"host": "h", "process": 1, "space": 2})",
        R"({"host": "h", "process": -1, "space": "s"})", R"({"host": "h", "process": 0, "space": "s"})",
        R"({"host": "h", "process": 1e300, "space": "s"})", R"({"host": "h", "process": 4294967297, "space": "s"})"}) {
    CAPTURE(text);
    std::ofstream{claim / "owner.json"} << text;
    CHECK(sweep::claimant_of(folder.path(), 5, 60.0) == "another program");
    CHECK_FALSE(Claim::take(folder.path(), 5, 60.0));
  }
  make_old(claim / "owner.json", 62.0);
  CHECK(Claim::take(folder.path(), 5, 60.0));
}

TEST_CASE("claim: held -> renewed until it is destroyed") {
  const TemporaryFolder folder;
  const auto claim = Claim::take(folder.path(), 0, 0.2);
  REQUIRE(claim);
  const fs::path owner = folder.path() / "0.0" / "owner.json";
  make_old(owner, 1000.0);
  const auto old = fs::last_write_time(owner);
  for (int i = 0; i < 500 && fs::last_write_time(owner) == old; ++i) std::this_thread::sleep_for(std::chrono::milliseconds{10});
  CHECK(fs::last_write_time(owner) > old);
}

TEST_CASE("attempt: complete -> the run's folder appears, and older attempts are removed") {
  const TemporaryFolder folder;
  const auto plan = plan_with({1.0});
  const fs::path run = folder.path() / plan[0].folder;
  leave_manifest(run.string() + ".attempt-4", "running", plan[0]);
  const Result result = sweep::attempt(folder.path(), plan[0], long_lease_s, [&](const fs::path& own) {
    CHECK(own == fs::path{run.string() + ".attempt-5"});
    CHECK_FALSE(fs::exists(run));
    leave_manifest(own, "complete", plan[0]);
  });
  CHECK(result.ended == Ended::complete);
  CHECK(sweep::is_complete(folder.path(), plan[0]));
  CHECK_FALSE(fs::exists(run.string() + ".attempt-4"));
  CHECK_FALSE(fs::exists(run.string() + ".attempt-5"));
  const Result again = sweep::attempt(folder.path(), plan[0], long_lease_s, [](const fs::path&) { FAIL("done twice"); });
  CHECK(again.ended == Ended::was_complete);
}

TEST_CASE("attempt: program killed at the very end of a run -> its files are removed at the next look") {
  const TemporaryFolder folder;
  const auto plan = plan_with({1.0, 2.0});
  const auto look = [&] {
    return sweep::attempt(folder.path(), plan[0], long_lease_s, [](const fs::path&) { FAIL("done twice"); }).ended;
  };
  const fs::path run = folder.path() / plan[0].folder;
  leave_manifest(run, "complete", plan[0]);
  leave_manifest(run.string() + ".attempt-3", "running", plan[0]);
  CHECK(look() == Ended::was_complete);
  CHECK_FALSE(fs::exists(run.string() + ".attempt-3"));

  const fs::path claims = folder.path() / sweep::claims_name;
  fs::create_directories(claims / "0.0");
  sweep::remove_claims(folder.path(), plan);
  CHECK(fs::exists(claims / "0.0"));  // another program may be at work on the other run
  fs::remove(claims / "0.0");
  sweep::remove_claims(folder.path(), plan);
  CHECK_FALSE(fs::exists(claims));
  fs::create_directories(claims / "0.0");
  leave_manifest(folder.path() / plan[1].folder, "complete", plan[1]);
  sweep::remove_claims(folder.path(), plan);
  CHECK_FALSE(fs::exists(claims));
}

TEST_CASE("claim: at any moment of its life -> has its owner's file") {
  const TemporaryFolder folder;
  constexpr std::size_t runs = 200;
  std::atomic<bool> done = false;
  std::atomic<std::size_t> nobodys = 0;
  std::jthread watcher{[&] {
    while (!done) {
      for (std::size_t run = 0; run < runs; ++run) {
        const fs::path claim = folder.path() / (std::to_string(run) + ".0");
        if (fs::exists(claim) && !fs::exists(claim / "owner.json")) ++nobodys;
      }
    }
  }};
  std::vector<Claim> claims;
  for (std::size_t run = 0; run < runs; ++run) {
    auto claim = Claim::take(folder.path(), run, long_lease_s);
    if (claim) claims.push_back(std::move(*claim));
  }
  done = true;
  watcher.join();
  CHECK(claims.size() == runs);
  CHECK(nobodys == 0);
}

TEST_CASE("attempt: claimed by another -> elsewhere, throws -> failed, ended by a signal -> stopped") {
  const TemporaryFolder folder;
  const auto plan = plan_with({1.0});
  const auto attempt = [&](const std::function<void(const fs::path&)>& work) {
    return sweep::attempt(folder.path(), plan[0], long_lease_s, work);
  };
  {
    const auto claim = Claim::take(folder.path() / sweep::claims_name, 0, long_lease_s);
    const Result result = attempt([](const fs::path&) { FAIL("is not ours"); });
    CHECK(result.ended == Ended::elsewhere);
    CHECK(result.text.find("process") != std::string::npos);
  }
  const Result failed = attempt([](const fs::path&) { throw std::runtime_error{"diverged"}; });
  CHECK(failed.ended == Ended::failed);
  CHECK(failed.text == "diverged");
  CHECK(attempt([&](const fs::path& own) { leave_manifest(own, "stopped", plan[0]); }).ended == Ended::stopped);
  CHECK_FALSE(sweep::is_complete(folder.path(), plan[0]));
}

TEST_CASE("attempt: two programs do the same run -> the slower one finds it done") {
  const TemporaryFolder folder;
  const auto plan = plan_with({1.0});
  const fs::path run = folder.path() / plan[0].folder;
  const auto faster = [&](const fs::path& own) {
    leave_manifest(run, "complete", plan[0]);
    fs::remove_all(own);
    throw std::runtime_error{"its folder is gone"};
  };
  CHECK(sweep::attempt(folder.path(), plan[0], long_lease_s, faster).ended == Ended::complete);
  fs::remove_all(run);
  const auto same_time = [&](const fs::path& own) {
    leave_manifest(own, "complete", plan[0]);
    leave_manifest(run, "complete", plan[0]);
  };
  CHECK(sweep::attempt(folder.path(), plan[0], long_lease_s, same_time).ended == Ended::complete);
  CHECK_FALSE(fs::exists(run.string() + ".attempt-0"));
}

TEST_CASE("shard: I/N -> the N shards have each run once, and any other text -> refused") {
  for (const char* bad : {"", "1", "0/4", "5/4", "1/0", "1/", "/4", "1/4x", "a/b", "-1/4"}) {
    CAPTURE(bad);
    CHECK_THROWS_AS(static_cast<void>(sweep::shard_of(bad)), std::invalid_argument);
  }
  std::vector<int> held(10, 0);
  for (const char* shard : {"1/3", "2/3", "3/3"}) {
    for (std::size_t run = 0; run < held.size(); ++run) held[run] += sweep::shard_of(shard).holds(run) ? 1 : 0;
  }
  CHECK(std::ranges::all_of(held, [](int times) { return times == 1; }));
}

TEST_CASE("work: runs of different length -> the longest first, equal ones in the plan's order") {
  const auto plan = plan_with({1.0, 3.0, 2.0, 3.0});
  CHECK(sweep::longest_first(plan) == std::vector<std::size_t>{1, 3, 2, 0});
  CHECK(sweep::longest_first(plan, {2, 2}) == std::vector<std::size_t>{1, 3});
}

TEST_CASE("work: some runs elsewhere or failing -> each run is tried once, claimed ones are awaited, the others complete") {
  const auto plan = plan_with({5.0, 4.0, 3.0, 2.0, 1.0});
  std::mutex mutex;
  std::vector<std::size_t> tried;
  const auto attempt = [&](const PlannedRun& run) -> Result {
    const std::scoped_lock lock{mutex};
    tried.push_back(run.index);
    if (run.index == 1) return {Ended::failed, "diverged"};
    if (run.index == 2) return {Ended::was_complete};
    if (run.index == 3 && std::ranges::count(tried, std::size_t{3}) == 1) return {Ended::elsewhere, "other (process 1)"};
    return {Ended::complete};
  };
  for (const std::size_t jobs : {1U, 3U}) {
    tried.clear();
    const sweep::Tally tally = sweep::work_through(plan, {}, jobs, attempt, [] { return true; });
    CHECK(tally.kept == 1);
    CHECK(tally.complete == 3);
    CHECK(tally.unfinished == std::vector<std::string>{"cell-1/replicate-00: diverged"});
    CHECK(tried.size() == 6);
  }
}

TEST_CASE("work: signal -> ends, and runs that were not begun are reported") {
  const auto plan = plan_with({2.0, 1.0});
  int tried = 0;
  const auto attempt = [&](const PlannedRun&) -> Result {
    ++tried;
    return {Ended::stopped, "status \"stopped\""};
  };
  const sweep::Tally tally = sweep::work_through(plan, {}, 1, attempt, [&] { return tried == 0; });
  CHECK(tally.unfinished ==
        std::vector<std::string>{"cell-0/replicate-00: status \"stopped\"", "cell-1/replicate-00: not begun"});
}

TEST_CASE("sweep folder: exists with the same plan -> joined, and with another -> refused") {
  const TemporaryFolder folder;
  const fs::path out = folder.path() / "sweep";
  const auto plan = plan_with({1.0, 2.0});
  sweep::make_or_join(out, plan, {{"sweep.toml", "[grid]\n"}, {"cell-0/replicates.json", "{}"}});
  CHECK(fs::exists(out / "cell-0" / "replicates.json"));
  CHECK(sweep::read_plan(out / sweep::plan_name).size() == 2);
  sweep::make_or_join(out, plan, {});
  auto other = plan;
  other[1].settings["rules.x"] = 9;
  try {
    sweep::make_or_join(out, other, {});
    FAIL("another plan was accepted");
  } catch (const std::invalid_argument& error) {
    CHECK(std::string{error.what()}.find("plan.jsonl:2: the folder holds another plan") != std::string::npos);
  }
  fs::create_directory(folder.path() / "notes");
  CHECK_THROWS_WITH_AS(sweep::make_or_join(folder.path() / "notes", plan, {}),
                       doctest::Contains("is not a sweep's folder; runs are never overwritten"), std::invalid_argument);
  for (const auto& entry : fs::directory_iterator{folder.path()}) {
    CHECK(entry.path().filename().string().find("making") == std::string::npos);
  }
}
