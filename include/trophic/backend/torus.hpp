// SPDX-License-Identifier: MIT
// A backend of points on a torus: a world without walls.
#pragma once

#include <cmath>
#include <trophic/backend/contract.hpp>
#include <trophic/habitat/ground_pose.hpp>
#include <trophic/support/units.hpp>

namespace trophic::backend {

/// A robot is a point. In each step it turns clockwise by a part of its target angle, then walks straight; who leaves the square
/// on one side comes in on the other, and distances are the shortest over its edges (View::distance_m). Points pass through each
/// other. The arena gives the size of the square; its walls have no effect. For worlds of equations and of patches, such as
/// wolf_sheep.
///
/// Ignores joints and walks of robots, Physics and the height and tilt of poses. No random draws; the same bits everywhere.
class Torus {
 public:
  static constexpr std::string_view name = "torus";
  static constexpr bool is_periodic = true;
  [[nodiscard]] static std::string version() { return "1"; }
  [[nodiscard]] static std::vector<std::string> remarks(const Physics&) {
    return {
        "physics.timestep_s, physics.integrator and physics.gravity_m_s2 have no effect: torus moves points, by "
        "backend.timestep_s"};
  }

  struct Params {
    using Backend = Torus;
    double speed_m_s = 1.0;
    double turn_1_s = 1.0;
    double timestep_s = 1.0;
    static constexpr auto fields() {
      return std::tuple{
          field("speed_m_s", &Params::speed_m_s, between(0.0, 1e6), "speed of every robot"),
          field("turn_1_s", &Params::turn_1_s, between(0.0, 1e3), "part of the target angle that it turns a second"),
          field("timestep_s", &Params::timestep_s, above_to(0.0, 10.0), "own step, simulated seconds")};
    }
  };

  struct Body {
    double x_m = 0.0;
    double y_m = 0.0;
    double heading_rad = 0.0;
    double target_angle_rad = 0.0;
    bool is_absent = false;
    static constexpr auto saved() {
      return std::tuple{&Body::x_m, &Body::y_m, &Body::heading_rad, &Body::target_angle_rad, &Body::is_absent};
    }
  };
  struct State {
    std::uint64_t steps = 0;
    std::vector<Body> bodies;
    static constexpr auto saved() { return std::tuple{&State::steps, &State::bodies}; }
  };

  /// Throws std::invalid_argument for a number outside its bound, no robots, and a start pose outside the square.
  Torus(const RobotModel& robot, const Arena& arena, std::span<const Pose> starts, const Physics& physics, const Params& params)
      : params_{params}, forward_rad_{robot.forward_rad}, height_m_{robot.rest_height_m}, half_side_m_{arena.half_side_m} {
    validate(physics, "physics");
    validate(params, "torus");
    if (starts.empty()) throw std::invalid_argument{"robots = 0: must be >= 1"};
    for (std::size_t i = 0; i < starts.size(); ++i) state_.bodies.push_back(body_at(i, starts[i]));
  }

  void advance_to(double time_s) {
    while (this->time_s() < time_s - 1e-9) {
      for (Body& body : state_.bodies) {
        if (!body.is_absent) step(body);
      }
      ++state_.steps;
    }
  }

  [[nodiscard]] std::size_t robots() const { return state_.bodies.size(); }
  [[nodiscard]] double time_s() const { return static_cast<double>(state_.steps) * params_.timestep_s; }
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
    if (!std::isfinite(target_angle_rad))
      throw std::invalid_argument{"target_angle_rad = " + number_text(target_angle_rad) + ": must be finite"};
    state_.bodies.at(robot).target_angle_rad = target_angle_rad;
  }

  void take_away(std::size_t robot) { state_.bodies.at(robot).is_absent = true; }
  void place(std::size_t robot, const Pose& pose) { state_.bodies.at(robot) = body_at(robot, pose); }
  [[nodiscard]] bool is_there(std::size_t robot) const { return !state_.bodies.at(robot).is_absent; }

  [[nodiscard]] State save() const { return state_; }
  /// Throws std::invalid_argument for a state with another number of robots.
  void restore(const State& state) {
    if (state.bodies.size() != state_.bodies.size()) {
      throw std::invalid_argument{"state.bodies.size() = " + std::to_string(state.bodies.size()) + ": must be " +
                                  std::to_string(state_.bodies.size())};
    }
    state_ = state;
  }

 private:
  [[nodiscard]] Body body_at(std::size_t robot, const Pose& pose) const {
    const GroundPose start = ground_pose(pose, forward_rad_);
    const bool is_inside = std::abs(start.x_m) <= half_side_m_ && std::abs(start.y_m) <= half_side_m_;
    if (!is_inside || !std::isfinite(start.heading_rad)) {
      throw std::invalid_argument{"start pose " + std::to_string(robot) + " at (" + number_text(start.x_m) + ", " +
                                  number_text(start.y_m) + "): must be finite and within +-" + number_text(half_side_m_)};
    }
    return {.x_m = start.x_m, .y_m = start.y_m, .heading_rad = start.heading_rad};
  }

  void step(Body& body) const {
    body.heading_rad = wrap_angle(body.heading_rad - params_.turn_1_s * params_.timestep_s * body.target_angle_rad);
    const double step_m = params_.speed_m_s * params_.timestep_s;
    const auto wrapped_m = [&](double at_m) { return std::remainder(at_m, 2.0 * half_side_m_); };
    body.x_m = wrapped_m(body.x_m + step_m * std::cos(body.heading_rad));
    body.y_m = wrapped_m(body.y_m + step_m * std::sin(body.heading_rad));
  }

  Params params_;
  double forward_rad_;
  double height_m_;
  double half_side_m_;
  State state_;
};
static_assert(SteeringDriven<Torus> && Placing<Torus>);

}  // namespace trophic::backend
