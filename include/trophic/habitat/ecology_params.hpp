// SPDX-License-Identifier: MIT
// The numbers of an experiment that do not belong to a rule: bodies, time scales, models, decisions.
#pragma once

#include <cstddef>
#include <string>
#include <trophic/habitat/cpg_integration.hpp>
#include <trophic/habitat/decision_order.hpp>
#include <trophic/habitat/phase_at_birth.hpp>
#include <trophic/habitat/without_target.hpp>
#include <trophic/params/params.hpp>
#include <tuple>

namespace trophic {

/// Bodies, time scales, models and the order of decisions (Sec. "Robot Body and Environment", "Cognitive Brain", "Birth",
/// "Outputs").
struct EcologyParams {
  std::size_t robots = 30;              ///< bodies, fixed for the whole run
  double duration_s = 6000.0;           ///< of the ecology's clock; the default duration of a program's run
  double tick_s = 2.0;                  ///< decision step, of the ecology's clock
  double first_tick_s = 0.0;            ///< rules act from the first tick at or after this; until then robots walk straight
  double control_hz = 60.0;             ///< gait control, per simulated second
  double clock_scale = 1.0;             ///< simulated seconds per second of the ecology's clock
  std::string robot = "spider";         ///< name or path of a robot file
  std::string arena = "walled_square";  ///< name or path of an arena file
  std::string gait;                     ///< name or path of a gait file; empty: the robot's default gait
  CpgIntegration cpg_integration = CpgIntegration::exact;
  std::size_t idle_control_steps = 0;  ///< control periods before the gait starts, with resting servos
  PhaseAtBirth phase_at_birth = PhaseAtBirth::kept;
  DecisionOrder decision_order = DecisionOrder::together;
  WithoutTarget without_target = WithoutTarget::decides;

  static constexpr auto fields() {
    return std::tuple{
        field("robots", &EcologyParams::robots, between(1, 10'000'000), "robot bodies, fixed for the whole run"),
        field("duration_s", &EcologyParams::duration_s, above_to(0.0, 1e12), "length of the run, ecology seconds"),
        field("tick_s", &EcologyParams::tick_s, above_to(0.0, 3600.0), "decision step, ecology seconds"),
        field("first_tick_s", &EcologyParams::first_tick_s, at_least(0.0), "rules act from then on, ecology seconds"),
        field("control_hz", &EcologyParams::control_hz, above_to(0.0, 1e5), "gait control per simulated second"),
        field("clock_scale", &EcologyParams::clock_scale, above_to(0.0, 1e3), "simulated seconds per ecology second"),
        field("robot", &EcologyParams::robot, "name or path of a robot file"),
        field("arena", &EcologyParams::arena, "name or path of an arena file"),
        field("gait", &EcologyParams::gait, "name or path of a gait file; empty: the robot's default"),
        field("cpg_integration", &EcologyParams::cpg_integration, "exact or rk4"),
        field("idle_control_steps", &EcologyParams::idle_control_steps, between(0, 1'000'000),
              "control periods before the gait starts"),
        field("phase_at_birth", &EcologyParams::phase_at_birth, "kept or reset: the gait's phase at a birth in the body"),
        field("decision_order", &EcologyParams::decision_order,
              "together or in_turn: whether robots see tags chosen earlier in the tick"),
        field("without_target", &EcologyParams::without_target,
              "decides or keeps_decision: a robot that perceives no adversary")};
  }
};

}  // namespace trophic
