// SPDX-License-Identifier: MIT
// Whole kinematic runs of both rule tables, byte for byte.
#include <doctest/doctest.h>

#include <regression/golden.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/arena.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/io/run_folder.hpp>
#include <trophic/observe/tally.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/released.hpp>

using namespace trophic;

namespace {

/// Runs a table at its own numbers and holds what a run's folder contains against golden/NAME.
template <class Rules>
void compare_run(const std::string& name) {
  using Kinematics = Ecology<Rules>;
  const std::filesystem::path written = test::written_folder(name);
  Kinematics ecology{typename Kinematics::Params{.seed = 1}, backend::Kinematic::Params{}};
  io::RunFolder folder{written};
  observe::Tally tally;
  ecology.run_until(600.0, folder, tally);
  for (const Cause cause : {Cause::caught, Cause::starved, Cause::sacrificed}) {
    INFO(enum_name(cause));
    CHECK(tally.deaths(cause) > 0);
  }
  test::remove_recording(written);
  test::hash_agents(written);
  test::strip_manifest(written);
  test::check_golden(name);
}

/// Ten times as many on ten times the floor, who are searched for another way: a hash of each table stands for its file.
template <class Rules>
void compare_crowd(const std::string& name) {
  using Kinematics = Ecology<Rules>;
  const std::filesystem::path written = test::written_folder(name);
  const std::filesystem::path run = test::written_folder(name + "_run");
  typename Kinematics::Params params{.seed = 1};
  params.ecology.robots = 300;
  params.rules.community.predators = 140;
  if constexpr (requires { params.rules.placement.half_extent_m; }) params.rules.placement.half_extent_m = 30.0;
  Habitat habitat = load_habitat(params.ecology);
  habitat.arena = load_arena("walled_square");
  habitat.arena.half_side_m = 32.0;
  habitat.arena.extent_m = 64.0;
  Kinematics ecology{params, backend::Kinematic::Params{}, habitat};
  io::RunFolder folder{run, {}, {.replay_hz = 0.0}};
  observe::Tally tally;
  ecology.run_until(600.0, folder, tally);
  CHECK(tally.deaths(Cause::caught) > 50);
  CHECK(tally.deaths(Cause::starved) > 20);
  test::FileLines hashes;
  for (const char* table : {"events.csv", "agents.csv", "phylogeny.csv", "genomes.csv"}) {
    std::string rows;
    for (const std::string& line : test::lines_of(run / table)) rows += line + '\n';
    hashes.push_back(table + std::string{" "} + hash_text(rows));
  }
  std::filesystem::remove_all(run);
  std::filesystem::create_directories(written);
  test::write_lines(written / "hashes.txt", hashes);
  test::check_golden(name);
}

}  // namespace

TEST_CASE("golden: run of the paper's rules -> same files") {
  compare_run<rules::Paper>("kinematic_paper");
}

TEST_CASE("golden: run of the released code's rules -> same files") {
  compare_run<rules::Released>("kinematic_released");
}

TEST_CASE("golden: crowd by the paper's rules -> same checksums") {
  compare_crowd<rules::Paper>("kinematic_paper_crowd");
}

TEST_CASE("golden: crowd by the released code's rules -> same checksums") {
  compare_crowd<rules::Released>("kinematic_released_crowd");
}
