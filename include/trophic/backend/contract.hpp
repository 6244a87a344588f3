// SPDX-License-Identifier: MIT
// The contract between the ecology and a physics engine; the library uses nothing else of an engine.
#pragma once

#include <span>
#include <trophic/habitat/arena.hpp>
#include <trophic/habitat/physics.hpp>
#include <trophic/habitat/pose.hpp>
#include <trophic/habitat/robot_model.hpp>
#include <trophic/params/archive.hpp>

namespace trophic {

/// Thrown if the state of a simulation became infinite or its engine reported instability. Holds the time and the robot.
class Diverged : public std::runtime_error {
 public:
  Diverged(double time_s, std::size_t robot, const std::string& what)
      : std::runtime_error{"simulation diverged at t = " + number_text(time_s) + " s, robot " + std::to_string(robot) + ": " +
                           what},
        time_s_{time_s},
        robot_{robot} {}
  [[nodiscard]] double time_s() const noexcept { return time_s_; }
  [[nodiscard]] std::size_t robot() const noexcept { return robot_; }

 private:
  double time_s_;
  std::size_t robot_;
};

/// A backend simulates n copies of one RobotModel in one Arena.
///
/// - constructed from (model, arena, one start pose of the root link per robot, physics, its own Params); joint angles start at
///   0, at rest; throws std::invalid_argument naming field, value and bound
/// - `advance_to(t)` takes whole steps until the first step time >= t (simulated seconds since the start; 1e-9 s of slack so
///   that rounding adds no step); throws Diverged; does nothing if t is in the past
/// - `pose(i)` returns the pose of the root link, `joint_angles(i)` the angles in the order of RobotModel::hinges (empty
///   without joints); both, and the setters of targets, throw std::out_of_range for a robot that does not exist
/// - `save`/`restore`: the full state, including warm starts, targets and time: a restored backend continues bitwise as the
///   saved one. State lists its members in saved(), so that checkpoints hold it (trophic/params/archive.hpp)
/// - results must not depend on the number of threads
/// - `remarks(physics)`: returns one sentence for every parameter of `physics` that has no effect on this backend, naming it;
///   manifests record them
/// - Params may have `prescribe(physics, table)`: see BackendChoice
/// - Params name their backend, `using Backend = Mine;`, so that an ecology is constructed from the parameters of a backend alone
template <class B>
concept Backend = requires(B backend, const B& observed, std::size_t robot, double time_s, const typename B::State& state) {
  { B::name } -> std::convertible_to<std::string_view>;
  { B::version() } -> std::convertible_to<std::string>;
  { B::remarks(Physics{}) } -> std::same_as<std::vector<std::string>>;
  requires Parameters<typename B::Params>;
  requires std::same_as<typename B::Params::Backend, B>;
  requires Savable<typename B::State>;
  requires std::constructible_from < B, const RobotModel&, const Arena&, std::span<const Pose>,
  const Physics&, const typename B::Params& > ;
  {backend.advance_to(time_s)};
  { observed.robots() } -> std::same_as<std::size_t>;
  { observed.time_s() } -> std::same_as<double>;
  { observed.pose(robot) } -> std::same_as<Pose>;
  { observed.joint_angles(robot) } -> std::convertible_to<std::span<const double>>;
  { observed.save() } -> std::same_as<typename B::State>;
  {backend.restore(state)};
};

/// A backend driven by servo targets in radians, one per hinge in the model's order, held until the next call and clipped to the
/// servo's limit.
template <class B>
concept JointDriven = Backend<B> && requires(B backend, std::size_t robot, std::span<const double> targets_rad) {
  {backend.set_joint_targets(robot, targets_rad)};
};

/// A backend whose robots may differ in their bodies. It is built with one model; then `embody(robot, model, pose)` replaces a
/// robot's body by this one at `pose`, with joint angles and targets 0, at rest and without warm start. The other robots are not
/// affected. It throws std::invalid_argument as the constructor does, and then changes nothing. `model(robot)`: returns the
/// robot's current model. `restore` takes a state of the same models. Models that no robot has use no memory.
template <class B>
concept Embodying = JointDriven<B> &&
    requires(B backend, const B& observed, std::size_t robot, const RobotModel& model, const Pose& pose) {
  {backend.embody(robot, model, pose)};
  { observed.model(robot) } -> std::same_as<const RobotModel&>;
};

/// A backend whose robots can be removed and added; all are present at first. `take_away(robot)`: removes the robot from the
/// world, so that nothing touches it, it does not move and it costs no time; it keeps its pose. `place(robot, pose)`: adds or
/// moves the robot in its initial state: joint angles and targets 0, at rest, without warm start; throws std::invalid_argument as
/// the constructor does. `embody` does the same with a different body. `is_there(robot)`: returns whether the robot is in the
/// world; this is part of the state.
template <class B>
concept Placing = Backend<B> && requires(B backend, const B& observed, std::size_t robot, const Pose& pose) {
  {backend.take_away(robot)};
  {backend.place(robot, pose)};
  { observed.is_there(robot) } -> std::same_as<bool>;
};

/// A backend driven by the target angle alone (no joints): positive turns right; held until the next call. A backend for tables
/// with a Pace or the act Effort also has `void set_pace(std::size_t robot, double pace)`: the factor of its speed and turning
/// rate, set before each tick and not a part of the state.
template <class B>
concept SteeringDriven = Backend<B> && requires(B backend, std::size_t robot, double target_angle_rad) {
  {backend.set_target_angle(robot, target_angle_rad)};
};

}  // namespace trophic
