// SPDX-License-Identifier: MIT
// Robots in a pen, stepped by the kernel of TROPHIC_LANES.
#pragma once

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <regression/golden.hpp>
#include <trophic/backend/mujoco.hpp>
#include <trophic/backend/mujoco/islands.hpp>
#include <trophic/backend/mujoco/lane_step.hpp>
#include <trophic/habitat/load/robot.hpp>

namespace trophic {
namespace {

/// A hash of all numbers of six spiders in a pen as narrow as they are, each second. No function of the C library is in it.
test::FileLines pen(double timestep_s, std::size_t steps, std::size_t threads, backend::kernel::StepFunction step) {
  const RobotModel robot = load_robot("spider");
  Arena arena;
  arena.half_side_m = 0.6;
  const auto depth = backend::mujoco::BoxDepth::engine;
  auto lanes = std::make_unique<backend::mujoco::Lanes>(depth, threads, step);
  backend::mujoco::Islands islands{robot, arena, {.timestep_s = timestep_s}, threads, depth, std::move(lanes)};
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
    REQUIRE(islands.advance(states, targets_rad, steps, next).end == backend::mujoco::GroupResult::End::done);
    states = std::move(next);
    const auto* const bytes = reinterpret_cast<const char*>(states.values().data());
    if (tick % 60 == 0) hashes.push_back(hash_text({bytes, states.values().size() * sizeof(double)}));
  }
  const auto [apart, alone, pairs, more, by_mujoco] = islands.counts();
  CHECK(pairs + more > apart + alone);
  return hashes;
}

/// Each instruction set of the kernel gives the numbers of the golden file.
void check_pen(const std::string& golden, double timestep_s, std::size_t steps) {
  if (backend::Mujoco::version() != "2.2.2") return;
  const test::FileLines hashes = pen(timestep_s, steps, 1, backend::kernel::fastest_step());
  CHECK(pen(timestep_s, steps, 2, backend::kernel::step_portable) == hashes);
#if defined(__x86_64__) && !defined(__AVX2__)
  if (__builtin_cpu_supports("avx2")) CHECK(pen(timestep_s, steps, 2, backend::kernel::step_avx2) == hashes);
#endif
  std::filesystem::create_directory(test::written_folder(golden));
  test::write_lines(std::filesystem::path{WRITTEN_DIR} / golden / "hashes.txt", hashes);
  test::check_golden(golden);
}

}  // namespace
}  // namespace trophic
