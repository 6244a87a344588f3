// SPDX-License-Identifier: MIT
// Converts target angles to motion: with joints by the gait's CPG and steering at the control rate, without joints by the target
// angle alone.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <trophic/backend/any_backend.hpp>
#include <trophic/backend/contract.hpp>
#include <trophic/control/locomotion/cpg.hpp>
#include <trophic/control/steering/contract.hpp>

namespace trophic::locomotion {

/// The control steps of a run.
struct ControlSteps {
  double hz = 60.0;  ///< per second of simulated time
  CpgIntegration integration = CpgIntegration::exact;
  std::int64_t idle_steps = 0;  ///< before gaits start, in which servos keep their targets; none without joints
};

/// Moves all robots of a backend. Every robot has its own copy of the gait's CPG, which keeps running when the occupant of the
/// body changes (Sec. "Targeted Steering"), unless robots have their own gaits. At each control step the CPG takes one
/// step, its outputs are steered and become servo targets (which the servos clip), and the backend advances to the end of the
/// step. With a different pace, a robot's CPG takes fewer or more steps in a control step. Simulated time is counted in whole
/// control steps.
template <control::Steering SteeringRule>
class Locomotion {
 public:
  Locomotion(const RobotModel& robot, const Gait& gait, SteeringRule steering, std::size_t robots, const ControlSteps& control)
      : steering_{std::move(steering)},
        hinges_{hinge_places(robot)},
        cpg_params_{.integration = control.integration, .step_s = 1.0 / control.hz},
        cpg_{gait, cpg_params_},
        states_{cpg_.initial_states(robots)},
        targets_rad_(robot.hinges.size()),
        control_{control} {}

  /// Takes `steps` control steps with these target angles, one per robot. With joints, `is_cancelled()` is called between the
  /// control steps; if it returns true, no further steps are taken. Returns whether all were taken.
  template <class IsCancelled>
  bool advance(AnyBackend& backend, std::int64_t steps, std::span<const double> target_angles_rad, IsCancelled&& is_cancelled) {
    if (backend.has_joints()) return advance_joints(backend, steps, target_angles_rad, is_cancelled);
    for (std::size_t robot = 0; robot < target_angles_rad.size(); ++robot) {
      backend.set_target_angle(robot, target_angles_rad[robot]);
      if (!paces_.empty()) backend.set_pace(robot, paces_[robot]);
    }
    wait(backend, steps);
    return true;
  }
  /// The same for a backend with joints of any type, without cancellation.
  template <class Bodies>
  void advance(Bodies& backend, std::int64_t steps, std::span<const double> target_angles_rad) {
    advance_joints(backend, steps, target_angles_rad, [] { return false; });
  }

  /// Sets the factors of the gaits' frequencies from now on, one per robot (all 1 if empty). They are not part of the state.
  void set_paces(std::vector<double> paces) { paces_ = std::move(paces); }

  /// Takes control steps without control: the CPG does not advance and the servos keep their targets.
  template <class Bodies>
  void wait(Bodies& backend, std::int64_t steps) {
    taken_ += steps;
    backend.advance_to(time_s());
  }

  /// Restarts one robot's CPG.
  void reset(std::size_t robot) {
    if (own_.empty()) {
      states_.col(static_cast<Eigen::Index>(robot)) = cpg_.initial_states();
    } else {
      own_[robot].states = own_[robot].cpg.initial_states();
    }
  }

  /// Gives each robot its own body and gait from now on, initially those of the constructor.
  void separate() {
    for (Eigen::Index robot = 0; robot < states_.cols(); ++robot) {
      own_.push_back({.hinges = hinges_, .cpg = cpg_, .states = states_.col(robot)});
    }
  }
  /// Replaces one robot's body and gait and starts its CPG. Call `separate` first.
  void walk_by(std::size_t robot, const RobotModel& model, const Gait& gait) {
    Cpg cpg{gait, cpg_params_};
    Eigen::MatrixXd states = cpg.initial_states();
    own_.at(robot) = {.hinges = hinge_places(model), .cpg = std::move(cpg), .states = std::move(states)};
  }

  /// Simulated time of the control steps so far.
  [[nodiscard]] double time_s() const { return static_cast<double>(taken_) / control_.hz; }

  /// The state that determines further motion: the CPGs and the number of steps.
  struct State {
    std::vector<double> cpg;
    std::int64_t taken = 0;
    static constexpr auto saved() { return std::tuple{&State::cpg, &State::taken}; }
  };
  [[nodiscard]] State save() const {
    State state{.cpg = {}, .taken = taken_};
    for_each_states(
        [&](const Eigen::MatrixXd& states) { state.cpg.insert(state.cpg.end(), states.data(), states.data() + states.size()); });
    return state;
  }
  /// Throws std::invalid_argument for a state with a different number of robots or different gaits.
  void restore(const State& state) {
    Eigen::Index size = 0;
    for_each_states([&](const Eigen::MatrixXd& states) { size += states.size(); });
    if (state.cpg.size() != static_cast<std::size_t>(size)) {
      throw std::invalid_argument{"state.cpg.size() = " + std::to_string(state.cpg.size()) + ": must be " + std::to_string(size)};
    }
    const double* from = state.cpg.data();
    const auto read = [&](Eigen::MatrixXd& states) {
      std::copy_n(from, states.size(), states.data());
      from += states.size();
    };
    if (own_.empty()) read(states_);
    for (Own& own : own_) read(own.states);
    taken_ = state.taken;
  }

 private:
  template <class Bodies, class IsCancelled>
  bool advance_joints(Bodies& backend, std::int64_t steps, std::span<const double> target_angles_rad,
                      IsCancelled&& is_cancelled) {
    for (std::int64_t step = 0; step < steps; ++step) {
      if (is_cancelled()) return false;
      if (taken_ < control_.idle_steps) {
        wait(backend, 1);
        continue;
      }
      if (own_.empty()) {
        step_together(backend, target_angles_rad);
      } else {
        step_apart(backend, target_angles_rad);
      }
      ++taken_;
      backend.advance_to(time_s());
    }
    return true;
  }

  template <class Bodies>
  void step_together(Bodies& backend, std::span<const double> target_angles_rad) {
    if (paces_.empty()) cpg_.step(states_);
    for (std::size_t robot = 0; robot < target_angles_rad.size(); ++robot) {
      if (!paces_.empty()) step_at_pace(cpg_, states_, robot, static_cast<Eigen::Index>(robot));
      if (!is_there(backend, robot)) continue;
      cpg_.outputs(states_, robot, targets_rad_);
      steering_.steer(target_angles_rad[robot], hinges_, targets_rad_);
      backend.set_joint_targets(robot, targets_rad_);
    }
  }

  template <class Bodies>
  void step_apart(Bodies& backend, std::span<const double> target_angles_rad) {
    for (std::size_t robot = 0; robot < target_angles_rad.size(); ++robot) {
      if (!is_there(backend, robot)) continue;
      Own& own = own_[robot];
      step_at_pace(own.cpg, own.states, robot, 0);
      targets_rad_.resize(own.hinges.size());
      own.cpg.outputs(own.states, 0, targets_rad_);
      steering_.steer(target_angles_rad[robot], own.hinges, targets_rad_);
      backend.set_joint_targets(robot, targets_rad_);
    }
  }

  /// Takes the steps of a robot's CPG in this control step: one, or as many as keep up with its pace.
  void step_at_pace(const Cpg& cpg, Eigen::MatrixXd& states, std::size_t robot, Eigen::Index column) const {
    const double pace = paces_.empty() ? 1.0 : paces_[robot];
    const auto before = static_cast<double>(taken_);
    const double steps = std::floor((before + 1.0) * pace) - std::floor(before * pace);
    for (int step = 0; step < static_cast<int>(steps); ++step) cpg.step(states, column);
  }

  template <class Bodies>
  [[nodiscard]] static bool is_there([[maybe_unused]] const Bodies& backend, [[maybe_unused]] std::size_t robot) {
    if constexpr (requires { backend.is_there(robot); }) return backend.is_there(robot);
    return true;
  }

  template <class Visitor>
  void for_each_states(const Visitor& visit) const {
    if (own_.empty()) visit(states_);
    for (const Own& own : own_) visit(own.states);
  }

  /// A robot with its own gait.
  struct Own {
    std::vector<HingePlace> hinges;
    Cpg cpg;
    Eigen::MatrixXd states;  ///< 2n x 1
  };

  SteeringRule steering_;
  std::vector<HingePlace> hinges_;
  Cpg::Params cpg_params_;
  Cpg cpg_;
  std::vector<Own> own_;  ///< one per robot, if they differ
  Eigen::MatrixXd states_;
  std::vector<double> targets_rad_;
  std::vector<double> paces_;  ///< one per robot; empty if all are 1
  ControlSteps control_;
  std::int64_t taken_ = 0;
};

}  // namespace trophic::locomotion
