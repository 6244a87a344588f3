// SPDX-License-Identifier: MIT
// A backend without physics: robots are oriented points that walk and turn.
#pragma once

#include <trophic/backend/contract.hpp>

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
  [[nodiscard]] static std::vector<std::string> remarks(const Physics& physics);

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
    bool operator==(const Body&) const = default;
    static constexpr auto saved() { return std::tuple{&Body::x_m, &Body::y_m, &Body::heading_rad, &Body::target_angle_rad}; }
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
            const Params& params);

  void advance_to(double time_s);

  [[nodiscard]] std::size_t robots() const { return state_.bodies.size(); }
  [[nodiscard]] double time_s() const { return static_cast<double>(state_.steps) * params_.timestep_s; }

  [[nodiscard]] Pose pose(std::size_t robot) const;

  /// Empty: no joints.
  [[nodiscard]] std::span<const double> joint_angles(std::size_t) const { return {}; }

  /// Throws std::invalid_argument unless finite.
  void set_target_angle(std::size_t robot, double target_angle_rad);

  [[nodiscard]] State save() const { return state_; }

  /// Throws std::invalid_argument for a state with another number of robots.
  void restore(const State& state);

 private:
  /// Along an arc of angle 2 h the chord is the arc's length times sin(h) / h and points h away from the old heading.
  void step(Body& body) const;

  Params params_;
  double speed_m_s_;
  double turn_rate_per_rad_;
  double forward_rad_;
  double height_m_;
  double limit_m_;
  State state_;
};
static_assert(SteeringDriven<Kinematic>);

}  // namespace trophic::backend

#if TROPHIC_HEADER_ONLY
#include <trophic/backend/kinematic.ipp>
#endif
