// SPDX-License-Identifier: MIT
// Whole kinematic runs of both rule tables, byte for byte.
#include <doctest/doctest.h>

#include <filesystem>
#include <regression/golden.hpp>
#include <string>
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/load/habitat.hpp>
#include <trophic/observe/run_folder.hpp>
#include <trophic/observe/tally.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/released.hpp>

using namespace trophic;

namespace {

/// Runs a table at its own numbers and holds what a run's folder contains against golden/NAME.
template <class Rules>
void compare_run(const std::string& name) {
  using Kinematics = Ecology<Rules, backend::Kinematic>;
  const std::filesystem::path written = test::written_folder(name);
  Kinematics ecology{typename Kinematics::Params{.seed = 1}};
  observe::RunFolder folder{written};
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

}  // namespace

TEST_CASE("a run of the paper's rules is the golden one") {
  compare_run<rules::Paper>("kinematic_paper");
}

TEST_CASE("a run of the released code's rules is the golden one") {
  compare_run<rules::Released>("kinematic_released");
}
