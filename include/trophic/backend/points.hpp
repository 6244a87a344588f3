// SPDX-License-Identifier: MIT
// The common part of backends of points: positions, headings, target angles, and which robots are present.
#pragma once

#include <cmath>
#include <trophic/backend/contract.hpp>
#include <trophic/habitat/ground_pose.hpp>
#include <trophic/support/units.hpp>

namespace trophic::backend {

/// Robots as oriented points. Height and tilt of given poses are ignored: reported poses are upright at the robot's rest height.
class Points {
 public:
  struct Body {
    double x_m = 0.0;
    double y_m = 0.0;
    double heading_rad = 0.0;
    double target_angle_rad = 0.0;
    bool is_absent = false;
    bool operator==(const Body&) const = default;
    static constexpr auto saved() {
      return std::tuple{&Body::x_m, &Body::y_m, &Body::heading_rad, &Body::target_angle_rad, &Body::is_absent};
    }
  };
  struct State {
    std::uint64_t steps = 0;
    std::vector<Body> bodies;
    bool operator==(const State&) const = default;
    static constexpr auto saved() { return std::tuple{&State::steps, &State::bodies}; }
  };

  [[nodiscard]] std::size_t robots() const { return state_.bodies.size(); }
  [[nodiscard]] double time_s() const { return static_cast<double>(state_.steps) * timestep_s_; }

  [[nodiscard]] Pose pose(std::size_t robot) const {
    const Body& body = state_.bodies.at(robot);
    const double half_yaw_rad = 0.5 * (body.heading_rad - forward_rad_);
    return {.position_m = {body.x_m, body.y_m, height_m_},
            .orientation = {std::cos(half_yaw_rad), 0.0, 0.0, std::sin(half_yaw_rad)}};
  }

  /// Empty: no joints.
  [[nodiscard]] std::span<const double> joint_angles(std::size_t) const { return {}; }

  /// Throws std::invalid_argument unless finite.
  void set_target_angle(std::size_t robot, double target_angle_rad) {
    if (!std::isfinite(target_angle_rad)) {
      throw std::invalid_argument{"target_angle_rad = " + number_text(target_angle_rad) + ": must be finite"};
    }
    state_.bodies.at(robot).target_angle_rad = target_angle_rad;
  }

  /// Sets the factor of a robot's speed and turning rate until the next call. Not a part of the state: set before each tick.
  /// Throws std::invalid_argument unless finite and >= 0.
  void set_pace(std::size_t robot, double pace) {
    if (!(pace >= 0.0 && std::isfinite(pace)))
      throw std::invalid_argument{"pace = " + number_text(pace) + ": must be finite and >= 0"};
    paces_.resize(robots(), 1.0);
    paces_.at(robot) = pace;
  }

  void take_away(std::size_t robot) { state_.bodies.at(robot).is_absent = true; }
  void place(std::size_t robot, const Pose& pose) { state_.bodies.at(robot) = body_at(robot, pose); }
  [[nodiscard]] bool is_there(std::size_t robot) const { return !state_.bodies.at(robot).is_absent; }

  [[nodiscard]] State save() const { return state_; }

  /// Throws std::invalid_argument for a state with a different number of robots.
  void restore(const State& state) {
    if (state.bodies.size() != state_.bodies.size()) {
      throw std::invalid_argument{"state.bodies.size() = " + std::to_string(state.bodies.size()) + ": must be " +
                                  std::to_string(state_.bodies.size())};
    }
    state_ = state;
  }

 protected:
  Points(const RobotModel& robot, const Arena& arena, double timestep_s)
      : forward_rad_{robot.forward_rad}, height_m_{robot.rest_height_m}, arena_{arena}, timestep_s_{timestep_s} {}

  /// Throws std::invalid_argument for no robots, and for a pose outside the square.
  void start_at(std::span<const Pose> starts) {
    if (starts.empty()) throw std::invalid_argument{"robots = 0: must be >= 1"};
    state_.bodies.reserve(starts.size());
    for (std::size_t i = 0; i < starts.size(); ++i) state_.bodies.push_back(body_at(i, starts[i]));
  }

  /// Calls `step(body, seconds)` for each present robot until the first step time >= `time_s`; the seconds are a step's length
  /// times the robot's pace.
  template <class Step>
  void step_until(double time_s, const Step& step) {
    while (this->time_s() < time_s - 1e-9) {
      for (std::size_t robot = 0; robot < robots(); ++robot) {
        Body& body = state_.bodies[robot];
        if (!body.is_absent) step(body, paces_.empty() ? timestep_s_ : timestep_s_ * paces_[robot]);
      }
      ++state_.steps;
    }
  }

  [[nodiscard]] const Arena& arena() const { return arena_; }

 private:
  [[nodiscard]] Body body_at(std::size_t robot, const Pose& pose) const {
    const GroundPose start = ground_pose(pose, forward_rad_);
    const std::string what = "start pose " + std::to_string(robot);
    const std::string place = what + " at (" + number_text(start.x_m) + ", " + number_text(start.y_m) + "): must ";
    const bool is_inside = std::abs(start.x_m) <= arena_.half_side_m && std::abs(start.y_m) <= arena_.half_side_m;
    if (!is_inside) throw std::invalid_argument{place + "be finite and within +-" + number_text(arena_.half_side_m)};
    if (!is_clear(arena_, start, 0.0)) throw std::invalid_argument{place + "not be in an obstacle"};
    if (!std::isfinite(start.heading_rad)) throw std::invalid_argument{what + ": its heading must be finite"};
    return {.x_m = start.x_m, .y_m = start.y_m, .heading_rad = start.heading_rad};
  }

  double forward_rad_;
  double height_m_;
  Arena arena_;
  double timestep_s_;
  State state_;
  std::vector<double> paces_ = {};  ///< one per robot; empty if all are 1
};

}  // namespace trophic::backend
