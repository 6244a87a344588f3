// SPDX-License-Identifier: MIT
// A MuJoCo run by the paper's rules, as long as no robots touch: from then on rounding grows tenfold a second. And robots in a
// pen.
#include <doctest/doctest.h>

#include <filesystem>
#include <regression/golden.hpp>
#include <trophic/backend/mujoco.hpp>
#include <trophic/backend/mujoco/islands.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/habitat/load/robot.hpp>
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

/// Each version of MuJoCo has golden files of its own; those of 2.2.2 are the reference.
void check_run(backend::Mujoco::Stepping stepping, const std::string& mode, std::uint64_t seed) {
  const std::string version = backend::Mujoco::version();
  const std::string name = (version == "2.2.2" ? "mujoco_paper" : "mujoco_" + version + "_paper") + mode;
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

/// A hash of all numbers of six spiders in a pen as narrow as they are, each second. No function of the C library is in it.
test::FileLines pen(std::size_t threads, backend::kernel::StepFunction step) {
  const RobotModel robot = load_robot("spider");
  Arena arena;
  arena.half_side_m = 0.6;
  backend::mujoco::Islands islands{robot, arena, Physics{}, threads, true, backend::mujoco::BoxDepth::engine, step};
  backend::mujoco::RobotStates states{islands.layout(), 6};
  backend::mujoco::Rows targets_rad{6, robot.hinges.size()};
  for (std::size_t i = 0; i < 6; ++i) {
    const Eigen::Vector3d place_m{0.4 * static_cast<double>(i / 2) - 0.4, i % 2 == 0 ? 0.25 : -0.25, robot.rest_height_m};
    states.set_root(i, {place_m, Eigen::Quaterniond::Identity()});
  }
  test::FileLines hashes;
  for (int tick = 1; tick <= 1200; ++tick) {
    for (std::size_t i = 0; i < 6 * robot.hinges.size(); ++i) {
      const auto [one, hinge] = std::pair{i % 6, i / 6};
      const double turns = tick * (0.011 + 0.001 * static_cast<double>(one)) + 0.3 * static_cast<double>(hinge);
      targets_rad[one][hinge] = 2.4 * std::abs(turns - std::floor(turns) - 0.5) - 0.6;
    }
    backend::mujoco::RobotStates next = states;
    REQUIRE(islands.advance(states, targets_rad, 14, next).end == backend::mujoco::GroupResult::End::done);
    states = std::move(next);
    const auto* const bytes = reinterpret_cast<const char*>(states.values().data());
    if (tick % 60 == 0) hashes.push_back(hash_text({bytes, states.values().size() * sizeof(double)}));
  }
  const auto [apart, alone, pairs, more, by_mujoco] = islands.counts();
  CHECK(pairs + more > apart + alone);
  return hashes;
}

}  // namespace

TEST_CASE("golden: MuJoCo run until robots touch -> same events") {
  check_run(backend::Mujoco::Stepping::fast, "", backend::Mujoco::version() == "2.2.2" ? 46 : 13);
}

TEST_CASE("golden: screening until robots touch -> same events") {
  check_run(backend::Mujoco::Stepping::screening, "_screening", 1000);
}

TEST_CASE("golden: MuJoCo robots that touch for long, each instruction set of the kernel -> same numbers") {
  if (backend::Mujoco::version() != "2.2.2") return;
  const test::FileLines hashes = pen(1, backend::kernel::fastest_step());
  CHECK(pen(2, backend::kernel::step_portable) == hashes);
#if defined(__x86_64__) && !defined(__AVX2__)
  if (__builtin_cpu_supports("avx2")) CHECK(pen(2, backend::kernel::step_avx2) == hashes);
#endif
  std::filesystem::create_directory(test::written_folder("mujoco_touching"));
  test::write_lines(std::filesystem::path{WRITTEN_DIR} / "mujoco_touching" / "hashes.txt", hashes);
  test::check_golden("mujoco_touching");
}
