// SPDX-License-Identifier: MIT
// A MuJoCo run by the paper's rules, as long as no robots touch: from then on rounding grows tenfold a second. And robots in a
// pen.
#include <doctest/doctest.h>

#include <filesystem>
#include <regression/pen.hpp>
#include <trophic/backend/mujoco.hpp>
#include <trophic/backend/mujoco/versions.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/io/event_log.hpp>
#include <trophic/observe/tally.hpp>
#include <trophic/rules/paper.hpp>

using namespace trophic;

namespace {

using Mujoco = Ecology<rules::Paper>;

/// The smallest distance of two robots at any tick.
struct Closest {
  double distance_m = std::numeric_limits<double>::infinity();
  void on_tick(const View& view) {
    for (BodyIndex one = 0; one < view.poses.size(); ++one) {
      for (BodyIndex two = 0; two < one; ++two) {
        distance_m = std::min(distance_m, trophic::distance_m(view.poses[one], view.poses[two]));
      }
    }
  }
};

/// The golden files of 2.2.2 are the reference; those of 3.5.0 are those of all versions whose boxes have their whole depth.
void check_run(backend::Mujoco::Stepping stepping, const std::string& mode, std::uint64_t seed) {
  const std::string version = backend::Mujoco::version();
  const std::string of = version == "2.2.2" ? "" : backend::mujoco::halves_box_depth ? version + "_" : "3.5.0_";
  const std::string name = "mujoco_" + of + "paper" + mode;
  const std::filesystem::path written = test::written_folder(name);
  std::filesystem::create_directory(written);
  Mujoco::Params params{.seed = seed};
  params.ecology.robots = 16;
  params.rules.capture.reach_m = 2.0;  // who catches from afar need not touch
  Mujoco ecology{params, backend::Mujoco::Params{.stepping = stepping}};
  io::EventLog events{written / "events.csv"};
  observe::Tally tally;
  Closest closest;
  ecology.run_until(260.0, events, tally, closest);
  if (!std::filesystem::exists(std::filesystem::path{GOLDEN_DIR} / name)) {
    MESSAGE("there are no golden files of MuJoCo " << version);
    return;
  }
  CHECK(closest.distance_m > 2.0 * ecology.habitat().robot.bounding_radius_m);
  CHECK(tally.deaths(Cause::caught) > 0);
  CHECK(tally.deaths(Cause::starved) > 0);
  test::check_golden(name);
}

}  // namespace

TEST_CASE("golden: MuJoCo run until robots touch -> same events") {
  check_run(backend::Mujoco::Stepping::fast, "", backend::Mujoco::version() == "2.2.2" ? 46 : 13);
}

TEST_CASE("golden: screening until robots touch -> same events") {
  check_run(backend::Mujoco::Stepping::screening, "_screening", 13);
}

TEST_CASE("golden: MuJoCo robots that touch for long, each instruction set of the kernel -> same numbers") {
  check_pen("mujoco_touching", 0.0012, 14);
}
