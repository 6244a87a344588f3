// SPDX-License-Identifier: MIT
// A backend without physics: robots are oriented points that walk and turn.
#pragma once

#include <algorithm>
#include <cmath>
#include <trophic/backend/contract.hpp>
#include <trophic/habitat/ground_pose.hpp>
#include <trophic/support/units.hpp>

namespace trophic::backend {

/// A robot is a point that walks along its heading at a constant speed and turns clockwise at a rate proportional to its target
/// angle: each step it follows an exact arc. Walls and the feet of slopes stop it (it slides along them); robots pass through
/// each other. For tests of rules and observers, and for fast trials.
///
/// Speed and turning rate are the robot's `walk`: its own gait, measured in MuJoCo at target angles of +-0.7 rad, those of the
/// cognitive brain. `ecology.gait` does not change them.
///
/// Ignores joints, Physics and the height and tilt of the start poses: reported poses stand upright at the robot's rest height.
/// No random draws; the same bits with every compiler and optimisation level that keeps IEEE arithmetic.
class Kinematic {
 public:
  static constexpr std::string_view name = "kinematic";
  [[nodiscard]] static std::string version() { return "1"; }
  [[nodiscard]] static std::vector<std::string> remarks(const Physics&) {
    return {
        "physics.timestep_s, physics.integrator and physics.gravity_m_s2 have no effect: kinematic moves points on exact arcs, "
        "by backend.timestep_s"};
  }

  struct Params {
    using Backend = Kinematic;
    double speed_scale = 1.0;
    double turn_scale = 1.0;
    double radius_m = 0.1;
    double timestep_s = 0.1;

    static constexpr auto fields() {
      return std::tuple{
          field("speed_scale", &Params::speed_scale, between(0.0, 100.0), "factor of the speed of the robot's walk"),
          field("turn_scale", &Params::turn_scale, between(0.0, 100.0), "factor of the turning rate of the robot's walk"),
          field("radius_m", &Params::radius_m, at_least(0.0), "distance at which walls stop the robot's centre"),
          field("timestep_s", &Params::timestep_s, above_to(0.0, 10.0), "own step, simulated seconds")};
    }
  };

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

  /// Throws std::invalid_argument for a number outside its bound, a robot without a walk, no robots, a radius that does not fit
  /// into the arena, and a start pose outside the walls.
  Kinematic(const RobotModel& robot, const Arena& arena, std::span<const Pose> starts, const Physics& physics,
            const Params& params)
      : params_{params},
        speed_m_s_{params.speed_scale * robot.walk.speed_m_s},
        turn_rate_per_rad_{params.turn_scale * robot.walk.turn_rate_per_rad},
        forward_rad_{robot.forward_rad},
        height_m_{robot.rest_height_m},
        half_side_m_{arena.half_side_m},
        limit_m_{arena.half_side_m - params.radius_m} {
    validate(physics, "physics");
    validate(params, "kinematic");
    if (!(robot.walk.speed_m_s > 0.0)) {
      throw std::invalid_argument{"robot " + robot.name + ": walk.speed_m_s = " + number_text(robot.walk.speed_m_s) +
                                  ": must be > 0 for a backend without joints; trophic measure-gait --walk measures it"};
    }
    if (!(robot.walk.turn_rate_per_rad > 0.0)) {
      throw std::invalid_argument{"robot " + robot.name + ": walk.turn_rate_per_rad = " +
                                  number_text(robot.walk.turn_rate_per_rad) + ": must be > 0, else brains cannot turn the robot"};
    }
    if (!(limit_m_ > 0.0)) {
      throw std::invalid_argument{"kinematic.radius_m = " + number_text(params.radius_m) + ": must be < the arena's half side, " +
                                  number_text(arena.half_side_m)};
    }
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
    if (!std::isfinite(target_angle_rad)) {
      throw std::invalid_argument{"target_angle_rad = " + number_text(target_angle_rad) + ": must be finite"};
    }
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
    if (!is_inside) {
      throw std::invalid_argument{"start pose " + std::to_string(robot) + " at (" + number_text(start.x_m) + ", " +
                                  number_text(start.y_m) + "): must be finite and within +-" + number_text(half_side_m_)};
    }
    if (!std::isfinite(start.heading_rad)) {
      throw std::invalid_argument{"start pose " + std::to_string(robot) + ": its heading must be finite"};
    }
    return {.x_m = start.x_m, .y_m = start.y_m, .heading_rad = start.heading_rad};
  }

  /// Along an arc of angle 2 h the chord is the arc's length times sin(h) / h and points h away from the old heading.
  void step(Body& body) const {
    const double half_turn_rad = -0.5 * turn_rate_per_rad_ * body.target_angle_rad * params_.timestep_s;
    const double shortening = half_turn_rad == 0.0 ? 1.0 : std::sin(half_turn_rad) / half_turn_rad;
    const double chord_m = speed_m_s_ * params_.timestep_s * shortening;
    const double direction_rad = body.heading_rad + half_turn_rad;
    body.x_m = std::clamp(body.x_m + chord_m * std::cos(direction_rad), -limit_m_, limit_m_);
    body.y_m = std::clamp(body.y_m + chord_m * std::sin(direction_rad), -limit_m_, limit_m_);
    body.heading_rad = wrap_angle(direction_rad + half_turn_rad);
  }

  Params params_;
  double speed_m_s_;
  double turn_rate_per_rad_;
  double forward_rad_;
  double height_m_;
  double half_side_m_;
  double limit_m_;
  State state_;
};
static_assert(SteeringDriven<Kinematic> && Placing<Kinematic>);

}  // namespace trophic::backend
