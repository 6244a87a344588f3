// SPDX-License-Identifier: MIT
// Targeted steering: slow down the hinges on the side to turn to.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <string_view>
#include <trophic/body/robot_model.hpp>
#include <trophic/params.hpp>
#include <tuple>
#include <vector>

namespace trophic::control {

/// Which side of a robot's axis of symmetry a hinge is on.
enum class Side { left, right, middle };
[[nodiscard]] constexpr std::array<std::string_view, 3> enum_names(Side) {
  return {"left", "right", "middle"};
}

/// Left where the cross product forward x grid position is positive, right where it is negative, middle on the axis. The spider's
/// axis lies at 45 degrees through its core, so x - y < 0 is left and x - y > 0 right.
[[nodiscard]] inline Side side_of(const Hinge& hinge, double forward_rad) {
  const double x = hinge.grid_position.x();
  const double y = hinge.grid_position.y();
  const double cross = std::cos(forward_rad) * y - std::sin(forward_rad) * x;
  if (std::abs(cross) < 1e-9) return Side::middle;
  return cross > 0.0 ? Side::left : Side::right;
}

/// Sec. "Targeted Steering": delta = ((pi - |alpha|) / pi)^exponent scales the targets of the hinges on the side to slow down:
/// the right side for a target angle alpha > 0 (turn right), the left side for alpha < 0. The paper's exponent is 2 (alpha =
/// +-0.7: delta = 0.604). No random draws.
class TargetedSteering {
 public:
  struct Params {
    double exponent = 2.0;

    static constexpr auto fields() {
      return std::tuple{field("exponent", &Params::exponent, at_least(0.0), "of delta = ((pi - |alpha|) / pi)^exponent")};
    }
  };

  /// Throws std::invalid_argument for a number outside its bound.
  explicit TargetedSteering(const RobotModel& robot) : TargetedSteering{robot, Params{}} {}
  TargetedSteering(const RobotModel& robot, const Params& params) : params_{params} {
    trophic::validate(params, "steering");
    for (const Hinge& hinge : robot.hinges) sides_.push_back(side_of(hinge, robot.forward_rad));
  }

  /// One entry per hinge of the robot.
  [[nodiscard]] const std::vector<Side>& sides() const { return sides_; }

  /// delta for a target angle; 1 at 0, 0 at +-pi and beyond.
  [[nodiscard]] double factor(double target_angle_rad) const {
    const double left_over = std::max(0.0, std::numbers::pi - std::abs(target_angle_rad));
    return std::pow(left_over / std::numbers::pi, params_.exponent);
  }

  /// Scales the joint targets of one robot in place; `targets_rad` has one entry per hinge.
  void apply(double target_angle_rad, std::span<double> targets_rad) const {
    if (target_angle_rad == 0.0) return;
    const Side slow = target_angle_rad > 0.0 ? Side::right : Side::left;
    const double delta = factor(target_angle_rad);
    for (std::size_t i = 0; i < targets_rad.size(); ++i) {
      if (sides_[i] == slow) targets_rad[i] *= delta;
    }
  }

 private:
  Params params_;
  std::vector<Side> sides_;
};

}  // namespace trophic::control
