// SPDX-License-Identifier: MIT
// From target angles to motion: the gait's CPG, steered, at the control rate; or the target angle alone where there are no
// joints.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <trophic/backend/any_backend.hpp>
#include <trophic/backend/contract.hpp>
#include <trophic/control/locomotion/cpg.hpp>
#include <trophic/control/steering/contract.hpp>
#include <trophic/habitat/sides.hpp>
#include <tuple>
#include <vector>

namespace trophic::locomotion {

/// Moves all robots of a backend. Every robot has its own copy of the gait's CPG, which runs on whoever lives in the body
/// (Sec. "Targeted Steering"). At each control step the CPG takes one step, its outputs are steered and become servo targets
/// (which the servos clip), and the backend advances to the end of the step. Simulated time is counted in whole control steps.
template <control::Steering SteeringRule>
class Locomotion {
 public:
  /// The gait starts after `idle_steps` control steps, in which servos keep their targets and, without joints, nothing is idle.
  Locomotion(const RobotModel& robot, const Gait& gait, SteeringRule steering, std::size_t robots, double control_hz,
             CpgIntegration integration, std::int64_t idle_steps = 0)
      : steering_{std::move(steering)},
        sides_{sides_of(robot)},
        cpg_{gait, {.integration = integration, .step_s = 1.0 / control_hz}},
        states_{cpg_.initial_states(robots)},
        targets_rad_(robot.hinges.size()),
        control_hz_{control_hz},
        idle_steps_{idle_steps} {}

  /// Takes `steps` control steps with these target angles, one per robot. `is_cancelled()` is asked between the control steps of
  /// a backend with joints; if it says true no more are taken. Returns whether all were.
  template <class IsCancelled>
  bool advance(AnyBackend& backend, std::int64_t steps, std::span<const double> target_angles_rad, IsCancelled&& is_cancelled) {
    if (backend.has_joints()) return advance_joints(backend, steps, target_angles_rad, is_cancelled);
    for (std::size_t robot = 0; robot < target_angles_rad.size(); ++robot) {
      backend.set_target_angle(robot, target_angles_rad[robot]);
    }
    wait(backend, steps);
    return true;
  }
  /// The same for a backend whose type is known, without giving up.
  template <JointDriven B>
  void advance(B& backend, std::int64_t steps, std::span<const double> target_angles_rad) {
    advance_joints(backend, steps, target_angles_rad, [] { return false; });
  }

  /// Lets control steps pass without control: the CPG rests, the servos keep their targets.
  template <class Bodies>
  void wait(Bodies& backend, std::int64_t steps) {
    taken_ += steps;
    backend.advance_to(time_s());
  }

  /// Starts one robot's rhythm anew.
  void reset(std::size_t robot) { states_.col(static_cast<Eigen::Index>(robot)) = cpg_.initial_states(); }

  /// Simulated time that the control steps taken so far add up to.
  [[nodiscard]] double time_s() const { return static_cast<double>(taken_) / control_hz_; }

  /// What decides how the robots move on: the states of the CPGs and the steps taken.
  struct State {
    std::vector<double> cpg;
    std::int64_t taken = 0;
    static constexpr auto saved() { return std::tuple{&State::cpg, &State::taken}; }
  };
  [[nodiscard]] State save() const { return {.cpg = {states_.data(), states_.data() + states_.size()}, .taken = taken_}; }
  /// Throws std::invalid_argument for a state of another number of robots or another gait.
  void restore(const State& state) {
    if (state.cpg.size() != static_cast<std::size_t>(states_.size())) {
      throw std::invalid_argument{"state.cpg.size() = " + std::to_string(state.cpg.size()) + ": must be " +
                                  std::to_string(states_.size())};
    }
    std::ranges::copy(state.cpg, states_.data());
    taken_ = state.taken;
  }

 private:
  template <class Bodies, class IsCancelled>
  bool advance_joints(Bodies& backend, std::int64_t steps, std::span<const double> target_angles_rad,
                      IsCancelled&& is_cancelled) {
    for (std::int64_t step = 0; step < steps; ++step) {
      if (is_cancelled()) return false;
      if (taken_ < idle_steps_) {
        wait(backend, 1);
        continue;
      }
      cpg_.step(states_);
      for (std::size_t robot = 0; robot < target_angles_rad.size(); ++robot) {
        cpg_.outputs(states_, robot, targets_rad_);
        steering_.steer(target_angles_rad[robot], sides_, targets_rad_);
        backend.set_joint_targets(robot, targets_rad_);
      }
      ++taken_;
      backend.advance_to(time_s());
    }
    return true;
  }

  SteeringRule steering_;
  std::vector<Side> sides_;
  Cpg cpg_;
  Eigen::MatrixXd states_;
  std::vector<double> targets_rad_;
  double control_hz_;
  std::int64_t idle_steps_;
  std::int64_t taken_ = 0;
};

}  // namespace trophic::locomotion
