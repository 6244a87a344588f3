// SPDX-License-Identifier: MIT
// The robots of both rule tables and the gecko walk in MuJoCo as stated in their files, so that kinematic runs move as MuJoCo's
// do.
#include <doctest/doctest.h>

#include <cmath>
#include <tools/gait_evolution/trial.hpp>
#include <trophic/backend/mujoco.hpp>
#include <trophic/habitat/habitat.hpp>
#include <trophic/habitat/load/gait.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/released.hpp>

namespace gait_evolution = trophic::gait_evolution;

namespace {

/// Shares. Other durations of the same 8 starts (45 to 55 s) moved the measured speed by 1 % and the turning rate by 4 %.
constexpr double speed_tolerance = 0.03;
constexpr double turn_tolerance = 0.08;

/// Compares the walk of a robot file with one measured with its ecology's gait and physics.
void check_walk(const trophic::EcologyParams& ecology, const trophic::Physics& physics) {
  const trophic::Habitat habitat = trophic::load_habitat(ecology);
  CHECK(habitat.gait.name == trophic::load_gait(habitat.robot.gait).name);
  const trophic::MeasuredWalk measured =
      gait_evolution::measure_walk(habitat.robot, habitat.gait, trophic::control::steering::TargetedSteering{},
                                   {.control_hz = ecology.control_hz, .cpg_integration = ecology.cpg_integration}, physics,
                                   trophic::backend::Mujoco::Params{}, 8);
  MESSAGE(habitat.robot.name << ": " << measured.speed_m_s << " m/s, " << measured.turn_rate_per_rad << " rad/s per rad");
  const trophic::MeasuredWalk& stated = habitat.robot.walk;
  CHECK(std::abs(stated.speed_m_s / measured.speed_m_s - 1.0) < speed_tolerance);
  CHECK(std::abs(stated.turn_rate_per_rad / measured.turn_rate_per_rad - 1.0) < turn_tolerance);
}

}  // namespace

TEST_CASE("measured walk: paper's robot with its table's gait and physics -> its file's figures") {
  check_walk(trophic::rules::Paper::ecology(), trophic::rules::Paper::physics());
}

TEST_CASE("measured walk: released code's robot with its table's gait and physics -> its file's figures") {
  check_walk(trophic::rules::Released::ecology(), trophic::rules::Released::physics());
}

TEST_CASE("measured walk: gecko with its own gait -> its file's figures") {
  trophic::EcologyParams ecology;
  ecology.robot = "gecko";
  check_walk(ecology, {});
}
