// SPDX-License-Identifier: MIT
// The common part of backends whose engine headers are included only by an .ipp.
#pragma once

#include <trophic/backend/contract.hpp>

namespace trophic::backend {

/// An engine that satisfies Embodying and Placing: see trophic/backend/contract.hpp for each function.
template <Savable SavedState>
class Engine {
 public:
  using State = SavedState;

  Engine() = default;
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;
  virtual ~Engine() = default;

  virtual void advance_to(double time_s) = 0;
  virtual void set_joint_targets(std::size_t robot, std::span<const double> targets_rad) = 0;
  virtual void embody(std::size_t robot, const RobotModel& model, const Pose& pose) = 0;
  virtual void take_away(std::size_t robot) = 0;
  [[nodiscard]] virtual bool is_there(std::size_t robot) const = 0;
  [[nodiscard]] virtual const RobotModel& model(std::size_t robot) const = 0;
  [[nodiscard]] virtual std::size_t robots() const = 0;
  [[nodiscard]] virtual double time_s() const = 0;
  [[nodiscard]] virtual Pose pose(std::size_t robot) const = 0;
  [[nodiscard]] virtual std::span<const double> joint_angles(std::size_t robot) const = 0;
  [[nodiscard]] virtual State save() const = 0;
  virtual void restore(const State& state) = 0;
};

/// Base of a backend that passes each call to its engine.
template <Savable SavedState>
class WithEngine {
 public:
  using State = SavedState;

  void advance_to(double time_s) { engine_->advance_to(time_s); }
  /// Throws std::invalid_argument unless there is one finite number per hinge.
  void set_joint_targets(std::size_t robot, std::span<const double> targets_rad) {
    engine_->set_joint_targets(robot, targets_rad);
  }
  /// Replaces a robot's body by this one at `pose`, with joint angles and targets 0 and at rest. Throws std::invalid_argument as
  /// the constructor does. Names and gaits of models have no effect here.
  void embody(std::size_t robot, const RobotModel& model, const Pose& pose) { engine_->embody(robot, model, pose); }
  /// Removes and adds a robot; a placed robot has its previous body.
  void take_away(std::size_t robot) { engine_->take_away(robot); }
  void place(std::size_t robot, const Pose& pose) { engine_->embody(robot, RobotModel{model(robot)}, pose); }
  [[nodiscard]] bool is_there(std::size_t robot) const { return engine_->is_there(robot); }
  /// The current body of a robot.
  [[nodiscard]] const RobotModel& model(std::size_t robot) const { return engine_->model(robot); }
  [[nodiscard]] std::size_t robots() const { return engine_->robots(); }
  [[nodiscard]] double time_s() const { return engine_->time_s(); }
  [[nodiscard]] Pose pose(std::size_t robot) const { return engine_->pose(robot); }
  [[nodiscard]] std::span<const double> joint_angles(std::size_t robot) const { return engine_->joint_angles(robot); }
  [[nodiscard]] SavedState save() const { return engine_->save(); }
  /// Throws std::invalid_argument for a state with different bodies (call `embody` first) or a different number of robots.
  void restore(const State& state) { engine_->restore(state); }

 protected:
  explicit WithEngine(std::unique_ptr<Engine<State>> engine) : engine_{std::move(engine)} {}
  [[nodiscard]] const Engine<State>& engine() const { return *engine_; }

 private:
  std::unique_ptr<Engine<State>> engine_;
};

}  // namespace trophic::backend
