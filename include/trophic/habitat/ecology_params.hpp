// SPDX-License-Identifier: MIT
// The parameters of an experiment that do not belong to a rule: bodies, time scales, models, decisions.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <trophic/params/params.hpp>

namespace trophic {

/// The integration of a CPG. `exact`: the matrix exponential exp(W h). W is antisymmetric, so this is a rotation and amplitudes
/// do not drift (for weights that turn an oscillator by at most some radians per step; gaits are far below that). `rk4`:
/// classical Runge-Kutta, which for a linear system is exp's Taylor series up to h^4 (as in the released code).
enum class CpgIntegration { exact, rk4 };
[[nodiscard]] constexpr std::array<std::string_view, 2> enum_names(CpgIntegration) {
  return {"exact", "rk4"};
}

/// The phase of a body's pattern generator when a new individual takes over the body. `kept`: it continues, as in the released
/// code. `reset`: it restarts. The paper is silent.
enum class PhaseAtBirth { kept, reset };
[[nodiscard]] constexpr std::array<std::string_view, 2> enum_names(PhaseAtBirth) {
  return {"kept", "reset"};
}

/// `together`: all robots perceive the same moment, before the first tag of the tick changes, so that the order of bodies does
/// not matter. `in_turn`: robots decide in the order of bodies, and each perceives the tags that earlier ones have chosen at this
/// tick, as in the released code. The paper is silent. In both cases common sensors are evaluated at the start of the tick.
enum class DecisionOrder { together, in_turn };
[[nodiscard]] constexpr std::array<std::string_view, 2> enum_names(DecisionOrder) {
  return {"together", "in_turn"};
}

/// `decides`: the brain decides as usual; the paper queries it every 2 s (Sec. "Outputs"). `keeps_decision`: the brain is not
/// run, and target angle and tag stay, as in the released code; so a hidden robot can never choose to become visible. Each sensor
/// defines its value without an adversary.
enum class WithoutTarget { decides, keeps_decision };
[[nodiscard]] constexpr std::array<std::string_view, 2> enum_names(WithoutTarget) {
  return {"decides", "keeps_decision"};
}

/// When a run ends before its duration: never, once some species is extinct, once at most one species is left, or once some
/// species is extinct or no body is spare. This can happen only in tables without a floor and a minimum number of predators. As
/// with the duration, runs that differ in it belong to the same experiment.
enum class EndsWhen { time_is_up, a_species_is_gone, one_species_is_left, gone_or_no_spare };
[[nodiscard]] constexpr std::array<std::string_view, 4> enum_names(EndsWhen) {
  return {"time_is_up", "a_species_is_gone", "one_species_is_left", "gone_or_no_spare"};
}

/// Whether a run with these numbers of members per species and so many bodies ends.
[[nodiscard]] constexpr bool ends_now(EndsWhen when, std::span<const std::size_t> members, std::size_t bodies) {
  const auto gone = static_cast<std::size_t>(std::ranges::count(members, std::size_t{0}));
  if (when == EndsWhen::one_species_is_left) return gone + 1 >= members.size();
  if (when == EndsWhen::gone_or_no_spare && std::accumulate(members.begin(), members.end(), std::size_t{0}) >= bodies)
    return true;
  return when != EndsWhen::time_is_up && gone > 0;
}

/// Longest run in seconds of the ecology's clock, for writers and readers of runs: a curve has a point every 200 s.
inline constexpr double longest_run_s = 1e8;

/// Bodies, time scales, models and the order of decisions (Sec. "Robot Body and Environment", "Cognitive Brain", "Birth",
/// "Outputs").
struct EcologyParams {
  std::size_t robots = 30;              ///< number of bodies, fixed for the whole run
  double duration_s = 6000.0;           ///< seconds of the ecology's clock; the default duration of a program's run
  double tick_s = 2.0;                  ///< decision step, seconds of the ecology's clock
  double first_tick_s = 0.0;            ///< rules act from the first tick at or after this; until then robots walk straight
  double control_hz = 60.0;             ///< control steps of the gait per simulated second
  double clock_scale = 1.0;             ///< simulated seconds per second of the ecology's clock
  std::string robot = "spider";         ///< name or path of a robot file
  std::string arena = "walled_square";  ///< name or path of an arena file
  std::string gait;                     ///< name or path of a gait file; empty: the robot's default gait
  CpgIntegration cpg_integration = CpgIntegration::exact;
  std::size_t idle_control_steps = 0;  ///< control periods before the gait starts, with resting servos
  PhaseAtBirth phase_at_birth = PhaseAtBirth::kept;
  DecisionOrder decision_order = DecisionOrder::together;
  WithoutTarget without_target = WithoutTarget::decides;
  EndsWhen ends_when = EndsWhen::time_is_up;

  static constexpr auto fields() {
    return std::tuple{
        field("robots", &EcologyParams::robots, between(1, 10'000'000), "number of robot bodies, fixed for the whole run"),
        field("duration_s", &EcologyParams::duration_s, above_to(0.0, longest_run_s),
              "length of the run, seconds of the ecology's clock"),
        field("tick_s", &EcologyParams::tick_s, above_to(0.0, 3600.0), "decision step, seconds of the ecology's clock"),
        field("first_tick_s", &EcologyParams::first_tick_s, at_least(0.0),
              "time from which rules act, seconds of the ecology's clock"),
        field("control_hz", &EcologyParams::control_hz, above_to(0.0, 1e5), "control steps of the gait per simulated second"),
        field("clock_scale", &EcologyParams::clock_scale, above_to(0.0, 1e3),
              "simulated seconds per second of the ecology's clock"),
        field("robot", &EcologyParams::robot, "name or path of a robot file"),
        field("arena", &EcologyParams::arena, "name or path of an arena file"),
        field("gait", &EcologyParams::gait, "name or path of a gait file; empty: the robot's default"),
        field("cpg_integration", &EcologyParams::cpg_integration, "exact or rk4"),
        field("idle_control_steps", &EcologyParams::idle_control_steps, between(0, 1'000'000),
              "control periods before the gait starts"),
        field("phase_at_birth", &EcologyParams::phase_at_birth, "phase of the gait at a birth in the body: kept or reset"),
        field("decision_order", &EcologyParams::decision_order,
              "whether robots see tags chosen earlier in the tick: in_turn (yes) or together (no)"),
        field("without_target", &EcologyParams::without_target, "a robot that perceives no adversary decides or keeps_decision"),
        field("ends_when", &EcologyParams::ends_when,
              "when a run ends: time_is_up, or earlier if a_species_is_gone, one_species_is_left or gone_or_no_spare")};
  }
};

}  // namespace trophic
