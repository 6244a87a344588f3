// SPDX-License-Identifier: MIT
// A backend that costs nothing: joints follow their targets at once and the robot slides on.
#pragma once

#include <cmath>
#include <trophic/backend/contract.hpp>

namespace trophic::test {

/// One robot. Each change of the first joint's target moves it by a tenth of that, m, along its root's x-axis; it turns left by a
/// tenth of what the last joint's target changes, rad. Diverges when a target passes Params::breaks_beyond_rad.
class ToyBackend {
 public:
  static constexpr std::string_view name = "toy";
  static std::string version() { return "1"; }
  static std::vector<std::string> remarks(const Physics&) { return {"physics has no effect: a toy"}; }
  struct Params {
    using Backend = ToyBackend;
    double breaks_beyond_rad = 100.0;
    static constexpr auto fields() { return std::tuple{field("breaks_beyond_rad", &Params::breaks_beyond_rad, above(0.0))}; }
  };
  struct State {
    double time_s = 0.0;
    double x_m = 0.0;
    double y_m = 0.0;
    double yaw_rad = 0.0;
    std::vector<double> targets_rad;
    static constexpr auto saved() {
      return std::tuple{&State::time_s, &State::x_m, &State::y_m, &State::yaw_rad, &State::targets_rad};
    }
  };

  ToyBackend(const RobotModel& robot, const Arena&, std::span<const Pose> starts, const Physics&, const Params& params)
      : params_{params}, z_m_{starts[0].position_m.z()} {
    const Eigen::Vector3d ahead = starts[0].orientation * Eigen::Vector3d::UnitX();
    state_ = {0.0, starts[0].position_m.x(), starts[0].position_m.y(), std::atan2(ahead.y(), ahead.x()),
              std::vector<double>(robot.hinges.size())};
  }

  void advance_to(double time_s) { state_.time_s = std::max(state_.time_s, time_s); }
  void set_joint_targets(std::size_t, std::span<const double> targets_rad) {
    const double step_m = 0.1 * std::abs(targets_rad.front() - state_.targets_rad.front());
    state_.yaw_rad += 0.1 * (targets_rad.back() - state_.targets_rad.back());
    state_.x_m += step_m * std::cos(state_.yaw_rad);
    state_.y_m += step_m * std::sin(state_.yaw_rad);
    state_.targets_rad.assign(targets_rad.begin(), targets_rad.end());
    for (const double target_rad : targets_rad) {
      if (std::abs(target_rad) > params_.breaks_beyond_rad) throw Diverged{state_.time_s, 0, "a toy broke"};
    }
  }

  [[nodiscard]] std::size_t robots() const { return 1; }
  [[nodiscard]] double time_s() const { return state_.time_s; }
  [[nodiscard]] Pose pose(std::size_t) const {
    return {{state_.x_m, state_.y_m, z_m_}, Eigen::Quaterniond{Eigen::AngleAxisd{state_.yaw_rad, Eigen::Vector3d::UnitZ()}}};
  }
  [[nodiscard]] std::span<const double> joint_angles(std::size_t) const { return state_.targets_rad; }
  [[nodiscard]] std::string speed_remark() const { return state_.time_s > 0.0 ? "a toy is slow" : ""; }
  [[nodiscard]] State save() const { return state_; }
  void restore(const State& state) { state_ = state; }

 private:
  Params params_;
  double z_m_;
  State state_;
};
static_assert(JointDriven<ToyBackend>);

}  // namespace trophic::test
