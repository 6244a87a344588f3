// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <atomic>
#include <iterator>
#include <set>
#include <sstream>
#include <support/temporary_folder.hpp>
#include <tools/replicates/folder.hpp>
#include <tools/replicates/parallel.hpp>
#include <tools/replicates/run.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/run/checkpoint/resume.hpp>
#include <trophic/support/json.hpp>

namespace {

using namespace trophic;
using test::message_of;
using test::TemporaryFolder;
namespace fs = std::filesystem;
using PaperRun = trophic::Experiment<rules::Paper>;

PaperRun brief(double duration_s = 200.0) {
  PaperRun experiment;
  experiment.ecology.duration_s = duration_s;
  return experiment;
}

std::string content(const fs::path& path) {
  std::ifstream file{path, std::ios::binary};
  return {std::istreambuf_iterator<char>{file}, {}};
}

constexpr std::array tables{"events.csv", "agents.csv", "phylogeny.csv", "genomes.csv"};

/// All contents of a replicate's folder that depend on the run itself.
std::string results(const fs::path& run) {
  std::string text;
  for (const char* table : tables) text += content(run / table);
  auto manifest = parse_json(content(run / "manifest.json"));
  manifest.erase("wall_s");
  manifest.erase("crc32");
  return text + json_text(manifest);
}

template <class... Observers>
replicates::Outcome run(const replicates::Plan& plan, std::ostream& out, const PaperRun& experiment = brief(),
                        Observers&... observers) {
  return replicates::run(experiment, backend::Kinematic::Params{}, plan, {}, out, observers...);
}

/// Throws at a time in the run of one seed.
struct Saboteur {
  std::uint64_t seed = 0;
  double at_s = 100.0;
  thread_local inline static std::uint64_t now = 0;
  void on_start(const observe::RunDescription& run, const View&) { now = run.seed; }
  void on_tick(const View& view) {
    if (now == seed && view.time_s >= at_s) throw std::runtime_error{"sabotage"};
  }
};

}  // namespace

TEST_CASE("replicates: master seed -> distinct seeds that follow from it alone and fit a double") {
  std::set<std::uint64_t> seeds;
  for (std::size_t i = 0; i < 1000; ++i) seeds.insert(replicates::seed_of(1, i));
  for (std::size_t i = 0; i < 1000; ++i) seeds.insert(replicates::seed_of(2, i));
  CHECK(seeds.size() == 2000);
  CHECK(*seeds.rbegin() < (std::uint64_t{1} << 53));
  const replicates::Plan few{.out = "x", .master_seed = 5, .count = 3};
  const replicates::Plan many{.out = "x", .master_seed = 5, .count = 30};
  CHECK(few.all()[2].seed == many.all()[2].seed);
  CHECK(many.all()[2].folder == fs::path{"x/replicate-02"});
}

TEST_CASE("replicates: another number of jobs -> the same bytes") {
  const TemporaryFolder folder;
  std::ostringstream out;
  for (const std::size_t jobs : {1U, 4U}) {
    const auto outcome = run({.out = folder.path() / std::to_string(jobs), .count = 5, .jobs = jobs}, out);
    CHECK(outcome.unfinished.empty());
    CHECK(outcome.complete == 5);
  }
  std::set<std::string> different;
  for (std::size_t i = 0; i < 5; ++i) {
    const std::string one = results(folder.path() / "1" / replicates::name_of(i));
    CHECK(one == results(folder.path() / "4" / replicates::name_of(i)));
    different.insert(one);
  }
  CHECK(different.size() == 5);
  CHECK(content(folder.path() / "1/replicates.json") == content(folder.path() / "4/replicates.json"));
  const auto list = parse_json(content(folder.path() / "1/replicates.json"));
  const auto manifest = parse_json(content(folder.path() / "1/replicate-03/manifest.json"));
  CHECK(list["replicates"][3]["seed"] == manifest["seed"]);
  CHECK(manifest["master_seed"] == Json("1"));
}

TEST_CASE("replicates: one fails -> the others complete, and --resume runs that one alone") {
  const TemporaryFolder folder;
  std::ostringstream out;
  const replicates::Plan plan{.out = folder.path() / "set", .count = 4, .jobs = 2};
  Saboteur saboteur{.seed = replicates::seed_of(1, 1)};
  const auto failed = run(plan, out, brief(), saboteur);
  CHECK(failed.complete == 3);
  REQUIRE(failed.unfinished.size() == 1);
  CHECK(failed.unfinished[0] == "replicate-01: sabotage");
  CHECK(checkpoint::status_of(plan.out / "replicate-01") == "failed");
  CHECK_FALSE(content(plan.out / "replicate-01/agents.csv").empty());

  const auto untouched = fs::last_write_time(plan.out / "replicate-02/agents.csv");
  replicates::Plan again = plan;
  again.resume = true;
  const auto resumed = run(again, out);
  CHECK(resumed.unfinished.empty());
  CHECK(resumed.kept == 3);
  CHECK(resumed.complete == 1);
  CHECK(fs::last_write_time(plan.out / "replicate-02/agents.csv") == untouched);
  CHECK(checkpoint::status_of(plan.out / "replicate-01.incomplete-1") == "failed");
  CHECK(
      out.str().find(
          "replicate-01 was incomplete (status \"failed\"; it has no checkpoint): kept as replicate-01.incomplete-1, run anew") !=
      std::string::npos);

  const replicates::Plan whole{.out = folder.path() / "whole", .count = 4};
  static_cast<void>(run(whole, out));
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(results(plan.out / replicates::name_of(i)) == results(whole.out / replicates::name_of(i)));
  }
}

TEST_CASE("replicates: killed with or without a manifest -> resumed or run anew, and larger count -> the set grows") {
  const TemporaryFolder folder;
  std::ostringstream out;
  replicates::Plan plan{.out = folder.path() / "set", .count = 3, .resume = true};  // resuming nothing starts it
  CHECK(run(plan, out).complete == 3);
  const std::string phylogeny = content(plan.out / "replicate-02/phylogeny.csv");
  fs::remove(plan.out / "replicate-00/manifest.json");
  fs::remove(plan.out / "replicate-00/checkpoint.bin");
  fs::remove_all(plan.out / "replicate-01");
  fs::remove(plan.out / "replicate-02/manifest.json");
  plan.count = 4;
  const auto outcome = run(plan, out);
  CHECK(outcome.kept == 0);
  CHECK(outcome.complete == 4);
  CHECK(fs::exists(plan.out / "replicate-00.incomplete-1/agents.csv"));
  CHECK_FALSE(fs::exists(plan.out / "replicate-01.incomplete-1"));
  CHECK(out.str().find("replicate-02 resumes from its checkpoint at 200 s") != std::string::npos);
  CHECK(content(plan.out / "replicate-02/phylogeny.csv") == phylogeny);
  CHECK(parse_json(content(plan.out / "replicates.json"))["count"] == Json(4));
}

TEST_CASE("replicates: existing set -> never overwritten, and resumed by the same experiment only") {
  const TemporaryFolder folder;
  std::ostringstream out;
  replicates::Plan plan{.out = folder.path() / "set", .count = 2};
  static_cast<void>(run(plan, out));
  const auto refusal = [&](const replicates::Plan& p, const PaperRun& experiment) {
    return message_of<std::invalid_argument>([&] { static_cast<void>(run(p, out, experiment)); });
  };
  CHECK(refusal(plan, brief()).find("exists already") != std::string::npos);
  plan.resume = true;
  PaperRun other = brief();
  other.rules.mutation.sd *= 2.0;
  CHECK(refusal(plan, other).find("replicates.json: fingerprint = ") != std::string::npos);
  CHECK(refusal(plan, brief(100.0)).find("until_s = 200.0: must be 100.0") != std::string::npos);
  replicates::Plan other_seed = plan;
  other_seed.master_seed = 2;
  CHECK(refusal(other_seed, brief()).find("master_seed = 1: must be 2") != std::string::npos);
  replicates::Plan fewer = plan;
  fewer.count = 1;
  CHECK(refusal(fewer, brief()).find("replicates = 1: must be >= 2") != std::string::npos);
  CHECK(refusal({.out = folder.path(), .resume = true}, brief()).find("only a folder of replicates") != std::string::npos);
  CHECK(refusal({.out = folder.path() / "new", .count = 0}, brief()) == "replicates = 0: must be >= 1");
  CHECK(refusal({.out = folder.path() / "new", .jobs = 0}, brief()) == "jobs = 0: must be >= 1");
  CHECK(refusal({.out = folder.path() / "new", .count = ~std::size_t{0}}, brief()) ==
        "replicates = 18446744073709551615: must be <= 100000");
  CHECK_FALSE(fs::exists(folder.path() / "new"));
}

TEST_CASE("replicates: two programs in one folder -> the second is refused") {
  const TemporaryFolder folder;
  const replicates::Plan plan{.out = folder.path() / "set", .count = 1, .resume = true};
  const observe::RunDescription any = Ecology<rules::Paper>{brief(), backend::Kinematic::Params{}}.describe(200.0);
  const replicates::Folder held{plan, any, {}};
  CHECK(message_of<std::runtime_error>([&] {
          const replicates::Folder second{plan, any, {}};
        }) == plan.out.string() + ": another program is running in it");
}

TEST_CASE("work in parallel: errors and a stop -> every item once, errors kept, none started after the stop") {
  std::atomic<int> sum = 0;
  const auto attempts = replicates::in_parallel(
      100, 4,
      [&](std::size_t i) {
        sum += static_cast<int>(i);
        if (i == 7) throw std::runtime_error{"seven"};
      },
      [] { return true; });
  CHECK(sum == 4950);
  CHECK(attempts[7].error == "seven");
  CHECK(attempts[8].error.empty());
  std::atomic<int> started = 0;
  const auto stopped = replicates::in_parallel(
      10, 1, [&](std::size_t) { ++started; }, [&] { return started < 3; });
  CHECK(started == 3);
  CHECK(stopped[2].started);
  CHECK_FALSE(stopped[3].started);
}
