// SPDX-License-Identifier: MIT
// A backend of points on a torus: a world without walls.
#pragma once

#include <trophic/backend/points.hpp>

namespace trophic::backend {

/// A robot is a point. In each step it turns clockwise by a part of its target angle and then walks straight. A robot that leaves
/// the square on one side re-enters it on the other, and distances are the shortest across its edges (View::distance_m). Points
/// pass through each other. The arena gives the size of the square; its walls have no effect. This backend is for worlds of
/// equations or patches, such as wolf_sheep.
///
/// Ignores joints and walks of robots, Physics and the height and tilt of poses. No random draws; the same bits everywhere.
class Torus : public Points {
 public:
  static constexpr std::string_view name = "torus";
  static constexpr bool is_periodic = true;
  [[nodiscard]] static std::string version() { return "1"; }
  [[nodiscard]] static std::vector<std::string> remarks(const Physics&) {
    return {
        "physics.timestep_s, physics.integrator and physics.gravity_m_s2 have no effect: torus moves points with "
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
          field("turn_1_s", &Params::turn_1_s, between(0.0, 1e3), "fraction of the target angle that a robot turns per second"),
          field("timestep_s", &Params::timestep_s, above_to(0.0, 10.0), "the backend's own time step, simulated seconds")};
    }
  };

  /// Throws std::invalid_argument for a number outside its bound, an arena with obstacles, no robots, and a start pose outside
  /// the square.
  Torus(const RobotModel& robot, const Arena& arena, std::span<const Pose> starts, const Physics& physics, const Params& params)
      : Points{robot, arena, params.timestep_s}, params_{params}, side_m_{2.0 * arena.half_side_m} {
    validate(physics, "physics");
    validate(params, "torus");
    if (!arena.obstacles.empty()) throw std::invalid_argument{"arena " + arena.name + ": has obstacles, which torus cannot have"};
    start_at(starts);
  }

  void advance_to(double time_s) {
    step_until(time_s, [this](Body& body, double step_s) { step(body, step_s); });
  }

 private:
  void step(Body& body, double step_s) const {
    body.heading_rad = wrap_angle(body.heading_rad - params_.turn_1_s * step_s * body.target_angle_rad);
    const double step_m = params_.speed_m_s * step_s;
    const auto wrapped_m = [&](double at_m) { return std::remainder(at_m, side_m_); };
    body.x_m = wrapped_m(body.x_m + step_m * std::cos(body.heading_rad));
    body.y_m = wrapped_m(body.y_m + step_m * std::sin(body.heading_rad));
  }

  Params params_;
  double side_m_;
};
static_assert(SteeringDriven<Torus> && Placing<Torus>);

}  // namespace trophic::backend
