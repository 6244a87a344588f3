// SPDX-License-Identifier: MIT
// The poses of all bodies at one moment, for observers of the motion between two decisions.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <trophic/habitat/arena.hpp>
#include <trophic/habitat/pose.hpp>
#include <trophic/habitat/robot_model.hpp>
#include <trophic/population/phenotype.hpp>

namespace trophic::observe {

/// The control steps of one tick, and those at which a frame is taken. Every tick has the same whole number of frames, spaced as
/// evenly as its steps allow. Its last step always has one, so that frames show the state on which rules act.
struct FrameTimes {
  std::int64_t steps = 1;    ///< control steps in a tick
  double tick_s = 1.0;       ///< length of a tick, seconds of the ecology's clock
  double clock_scale = 1.0;  ///< simulated seconds per second of the ecology's clock

  /// The number of frames per tick that is closest to `hz` frames per simulated second: at least one and at most one per step; 0
  /// if `hz` is 0.
  [[nodiscard]] std::int64_t per_tick(double hz) const {
    if (!(hz > 0.0)) return 0;
    return static_cast<std::int64_t>(std::clamp(std::round(hz * tick_s * clock_scale), 1.0, static_cast<double>(steps)));
  }

  /// The step after which frame `frame` of `per_tick` is taken; frame 0 is the start of the tick.
  [[nodiscard]] std::int64_t step_of(std::int64_t frame, std::int64_t per_tick) const {
    return (frame * steps + per_tick - 1) / per_tick;
  }

  /// The first step after `step` with a frame at that rate, at the latest `steps`.
  [[nodiscard]] std::int64_t next(std::int64_t step, double hz) const {
    const std::int64_t frames = per_tick(hz);
    return frames == 0 ? steps : step_of(step * frames / steps + 1, frames);
  }

  /// Whether a frame at that rate is taken after `step`.
  [[nodiscard]] bool due(std::int64_t step, double hz) const { return hz > 0.0 && (step == 0 || next(step - 1, hz) == step); }
};

/// One moment. Its spans are valid during the call.
struct Frame {
  double time_s = 0.0;                       ///< the ecology's clock
  FrameTimes times;                          ///< times in every tick of the run
  std::span<const Pose> roots;               ///< pose of each robot's root link
  std::span<const double> joint_angles_rad;  ///< robot by robot, in the order of the model's hinges; empty without joints
  const RobotModel& robot;                   ///< the model of all robots, unless `phenotypes` has one for each
  const Arena& arena;
  std::span<const Phenotype> phenotypes = {};     ///< one per robot; empty if all have the same body
  std::span<const std::size_t> first_angle = {};  ///< index of each robot's first joint angle; empty if all have the same number

  /// The model of a robot, and its joint angles.
  [[nodiscard]] const RobotModel& model(std::size_t index) const {
    return phenotypes.empty() || !phenotypes[index].robot ? robot : *phenotypes[index].robot;
  }
  [[nodiscard]] std::span<const double> joint_angles(std::size_t index) const {
    const std::size_t each = joint_angles_rad.size() / roots.size();
    if (first_angle.empty()) return joint_angles_rad.subspan(index * each, each);
    const std::size_t end = index + 1 < first_angle.size() ? first_angle[index + 1] : joint_angles_rad.size();
    return joint_angles_rad.subspan(first_angle[index], end - first_angle[index]);
  }
};

}  // namespace trophic::observe
