// SPDX-License-Identifier: MIT
// A backend without physics: robots are oriented points that walk and turn.
#pragma once

#include <algorithm>
#include <limits>
#include <trophic/backend/backend_choice.hpp>
#include <trophic/backend/points.hpp>

namespace trophic::backend {

/// A robot is a point that walks along its heading at a constant speed and turns clockwise at a rate proportional to its target
/// angle: each step it follows an exact arc. Walls, obstacles and the feet of slopes stop it (it slides along them); robots
/// pass through each other, and rough ground is flat. This backend is for tests of rules and observers and for fast trials.
///
/// Speed and turning rate are the robot's `walk`, measured with its own gait in MuJoCo at target angles of +-0.7 rad, those of
/// the cognitive brain. `ecology.gait` does not change them; the pace of a robot scales both.
///
/// Ignores joints, Physics and the height and tilt of the start poses: reported poses stand upright at the robot's rest height.
/// No random draws; the same bits with every compiler and optimisation level that keeps IEEE arithmetic.
class Kinematic : public Points {
 public:
  static constexpr std::string_view name = "kinematic";
  [[nodiscard]] static std::string version() { return "1"; }
  [[nodiscard]] static std::vector<std::string> remarks(const Physics&) {
    return {
        "physics.timestep_s, physics.integrator and physics.gravity_m_s2 have no effect: kinematic moves points on exact arcs "
        "with backend.timestep_s"};
  }

  struct Params {
    using Backend = Kinematic;
    double speed_scale = 1.0;
    double turn_scale = 1.0;
    double radius_m = 0.1;
    double timestep_s = 0.1;

    static constexpr auto fields() {
      return std::tuple{
          field("speed_scale", &Params::speed_scale, between(0.0, 100.0), "factor applied to the speed of the robot's walk"),
          field("turn_scale", &Params::turn_scale, between(0.0, 100.0), "factor applied to the turning rate of the robot's walk"),
          field("radius_m", &Params::radius_m, at_least(0.0), "distance at which walls stop the robot's centre"),
          field("timestep_s", &Params::timestep_s, above_to(0.0, 10.0), "the backend's own time step, simulated seconds")};
    }
  };

  /// Throws std::invalid_argument for a number outside its bound, a robot without a walk, no robots, a radius that does not fit
  /// into the arena, and a start pose outside the walls.
  Kinematic(const RobotModel& robot, const Arena& arena, std::span<const Pose> starts, const Physics& physics,
            const Params& params)
      : Points{robot, arena, params.timestep_s},
        params_{params},
        speed_m_s_{params.speed_scale * robot.walk.speed_m_s},
        turn_rate_per_rad_{params.turn_scale * robot.walk.turn_rate_per_rad},
        limit_m_{arena.half_side_m - params.radius_m} {
    validate(physics, "physics");
    validate(params, "kinematic");
    if (!(robot.walk.speed_m_s > 0.0)) {
      throw std::invalid_argument{"robot " + robot.name + ": walk.speed_m_s = " + number_text(robot.walk.speed_m_s) +
                                  ": must be > 0 for a backend without joints; trophic measure-gait --walk measures it"};
    }
    if (!(robot.walk.turn_rate_per_rad > 0.0)) {
      throw std::invalid_argument{"robot " + robot.name + ": walk.turn_rate_per_rad = " +
                                  number_text(robot.walk.turn_rate_per_rad) + ": must be > 0, or brains cannot turn the robot"};
    }
    if (!(limit_m_ > 0.0)) {
      throw std::invalid_argument{"kinematic.radius_m = " + number_text(params.radius_m) + ": must be < the arena's half side, " +
                                  number_text(arena.half_side_m)};
    }
    for (const Obstacle& one : arena.obstacles) thinnest_m_ = std::min(thinnest_m_, one.radius_m + params.radius_m);
    start_at(starts);
  }

  void advance_to(double time_s) {
    step_until(time_s, [this](Body& body, double step_s) { step(body, step_s); });
  }

 private:
  /// Along an arc of angle 2 h the chord is the arc's length times sin(h) / h and points h away from the old heading.
  void step(Body& body, double step_s) const {
    const double half_turn_rad = -0.5 * turn_rate_per_rad_ * body.target_angle_rad * step_s;
    const double shortening = half_turn_rad == 0.0 ? 1.0 : std::sin(half_turn_rad) / half_turn_rad;
    const double chord_m = speed_m_s_ * step_s * shortening;
    const double direction_rad = body.heading_rad + half_turn_rad;
    if (arena().obstacles.empty()) {
      body.x_m = std::clamp(body.x_m + chord_m * std::cos(direction_rad), -limit_m_, limit_m_);
      body.y_m = std::clamp(body.y_m + chord_m * std::sin(direction_rad), -limit_m_, limit_m_);
    } else {
      const double parts = std::ceil(std::max(1.0, std::abs(chord_m) / (0.5 * thinnest_m_)));
      for (double part = 0.0; part < parts; ++part)
        walk_among_obstacles(body, chord_m / parts * std::cos(direction_rad), chord_m / parts * std::sin(direction_rad));
    }
    body.heading_rad = wrap_angle(direction_rad + half_turn_rad);
  }

  /// Moves less than half of an obstacle's width at once. A robot that would get stuck between two obstacles stays where it was.
  void walk_among_obstacles(Body& body, double dx_m, double dy_m) const {
    double x_m = std::clamp(body.x_m + dx_m, -limit_m_, limit_m_);
    double y_m = std::clamp(body.y_m + dy_m, -limit_m_, limit_m_);
    for (const Obstacle& one : arena().obstacles) {
      const double inside_m = params_.radius_m - distance_m(one, x_m, y_m);
      if (inside_m <= 0.0) continue;
      const auto [axis_x_m, axis_y_m] = closest_on_axis(one, x_m, y_m);
      const double from_axis_m = std::sqrt((x_m - axis_x_m) * (x_m - axis_x_m) + (y_m - axis_y_m) * (y_m - axis_y_m));
      if (from_axis_m == 0.0) return;
      x_m = std::clamp(x_m + (inside_m + 1e-12) * (x_m - axis_x_m) / from_axis_m, -limit_m_, limit_m_);
      y_m = std::clamp(y_m + (inside_m + 1e-12) * (y_m - axis_y_m) / from_axis_m, -limit_m_, limit_m_);
    }
    const auto holds = [&](const Obstacle& one) {
      const double now_m = distance_m(one, x_m, y_m);
      return now_m < params_.radius_m && now_m < distance_m(one, body.x_m, body.y_m);
    };
    if (std::ranges::any_of(arena().obstacles, holds)) return;
    body.x_m = x_m;
    body.y_m = y_m;
  }

  Params params_;
  double thinnest_m_ =
      std::numeric_limits<double>::infinity();  ///< smallest distance from an obstacle's axis at which it stops a robot
  double speed_m_s_;
  double turn_rate_per_rad_;
  double limit_m_;
};
static_assert(SteeringDriven<Kinematic> && Placing<Kinematic>);

}  // namespace trophic::backend

#if !TROPHIC_HEADER_ONLY
extern template trophic::BackendChoice::BackendChoice(trophic::backend::Kinematic::Params);
#endif
