// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/temporary_folder.hpp>
#include <tools/analysis/data/sweep_runs.hpp>
#include <trophic/support/whole_file.hpp>
#include <unit/analysis/sweep_grids.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::analysis;

namespace {

/// A sweep of two cells with shadows on the disk.
struct Disk : test::TemporaryFolder {
  std::vector<sweep::PlannedRun> plan = test::plan_of({.cells = 2, .replicates = 2, .with_shadow = true});
  Disk() { test::write_sweep(path(), plan); }
  [[nodiscard]] SweepRuns read() const { return read_sweep(path()); }
  [[nodiscard]] std::string refused() const {
    return test::message_of<std::invalid_argument>([&] { static_cast<void>(read()); });
  }
  /// The manifest of a run with some of its text replaced.
  void change(std::size_t run, const std::string& what, const std::string& by) const {
    const auto file = path() / plan[run].folder / "manifest.json";
    std::string text = read_whole_file(file);
    std::ofstream{file} << text.replace(text.find(what), what.size(), by);
  }
};

}  // namespace

TEST_CASE("sweep runs: every run as planned -> no remark") {
  const Disk disk;
  CHECK(is_sweep(disk.path()));
  CHECK_FALSE(is_sweep(disk.path() / "cell-0"));
  const SweepRuns sweep = disk.read();
  CHECK(sweep.is_there == std::vector<bool>(8, true));
  CHECK(sweep.missing.empty());
  CHECK(sweep.webs.size() == 1);
  CHECK(sweep.grid.cells.size() == 2);
  CHECK(sweep.folder_of(6) == disk.path() / "cell-1/shadow/replicate-0");
}

TEST_CASE("sweep runs: absent or incomplete run -> missing, with the reason") {
  const Disk disk;
  std::filesystem::remove_all(disk.path() / disk.plan[1].folder);
  std::filesystem::remove(disk.path() / disk.plan[3].folder / "manifest.json");
  disk.change(4, "\"complete\"", "\"stopped\"");
  disk.change(5, "{", "");
  const SweepRuns sweep = disk.read();
  CHECK(sweep.is_there == std::vector<bool>{true, false, true, false, false, false, true, true});
  CHECK(missing_line(sweep).starts_with(
      "4 of 8 runs missing: run 1 (cell-0/replicate-1): no such folder; run 3 (cell-0/shadow/replicate-1): no manifest.json; run "
      "4 "
      "(cell-1/replicate-0): status \"stopped\", must be \"complete\"; run 5 (cell-1/replicate-1): "));
}

TEST_CASE("of many missing runs the first are named") {
  const test::TemporaryFolder folder;
  const auto plan = test::plan_of({.cells = 1, .replicates = 20});
  test::write_sweep(folder.path(), plan);
  for (std::size_t i = 1; i < 20; ++i) std::filesystem::remove_all(folder.path() / plan[i].folder);
  const std::string line = missing_line(read_sweep(folder.path()));
  CHECK(line.starts_with("19 of 20 runs missing: run 1 (cell-0/replicate-1): no such folder; "));
  CHECK(line.ends_with("run 10 (cell-0/replicate-10): no such folder; and 9 more"));
  std::filesystem::remove_all(folder.path() / plan[0].folder);
  CHECK(test::message_of<std::invalid_argument>([&] { static_cast<void>(read_sweep(folder.path())); }) ==
        folder.path().string() + ": has no complete run; run 0 (cell-0/replicate-0): no such folder");
}

TEST_CASE("sweep runs: another run in the place of the planned one -> refused") {
  for (const auto& [what, by, message] :
       {std::tuple{"\"f1\"", "\"f0\"", "fingerprint = f0: must be f1, as the plan has it for run 4"},
        std::tuple{"\"seed\": 100", "\"seed\": 7", "seed = 7: must be 100, as the plan"},
        std::tuple{"6000", "5", "until_s = 5: must be 6000, as the plan"}}) {
    const Disk disk;
    disk.change(4, what, by);
    CAPTURE(disk.refused());
    CHECK(disk.refused().find("cell-1/replicate-0/manifest.json: " + std::string{message}) != std::string::npos);
  }
}

TEST_CASE("sweep runs: run in a shadow's place that is not a shadow -> refused") {
  const Disk disk;
  disk.change(6, "nothing_inherited", "own_copy");
  CHECK(disk.refused().find("cell-1/shadow/replicate-0: is not a neutral shadow of ") != std::string::npos);
}
