// SPDX-License-Identifier: MIT
// Robots with joints and exchangeable bodies that cost nothing: joints follow their targets at once and robots slide on.
#pragma once

#include <algorithm>
#include <cmath>
#include <trophic/backend/contract.hpp>

namespace trophic::test {

/// Each change of a robot's first joint moves it by a tenth of that, m, along its root's x-axis, until it has left the arena's
/// middle by 10 m. From `second_breaks_s` on robot 1 breaks, and robot 0 is blamed, until it has its third body.
class ToyBodies {
 public:
  static constexpr std::string_view name = "toy_bodies";
  static std::string version() { return "1"; }
  static std::vector<std::string> remarks(const Physics&) { return {}; }
  struct Params {
    using Backend = ToyBodies;
    double breaks_beyond_rad = 100.0;
    double second_breaks_s = 1e6;
    static constexpr auto fields() {
      return std::tuple{field("breaks_beyond_rad", &Params::breaks_beyond_rad, above(0.0)),
                        field("second_breaks_s", &Params::second_breaks_s, above(0.0))};
    }
  };
  struct One {
    double x_m = 0.0;
    double y_m = 0.0;
    double z_m = 0.0;
    double yaw_rad = 0.0;
    std::vector<double> targets_rad = {};
    double bodies = 1.0;
    static constexpr auto saved() {
      return std::tuple{&One::x_m, &One::y_m, &One::z_m, &One::yaw_rad, &One::targets_rad, &One::bodies};
    }
  };
  struct State {
    double time_s = 0.0;
    std::vector<One> robots = {};
    static constexpr auto saved() { return std::tuple{&State::time_s, &State::robots}; }
  };

  ToyBodies(const RobotModel& robot, const Arena&, std::span<const Pose> starts, const Physics&, const Params& params)
      : params_{params}, models_(starts.size(), robot) {
    for (const Pose& start : starts) state_.robots.push_back(at_rest(robot, start));
  }

  void advance_to(double time_s) {
    state_.time_s = std::max(state_.time_s, time_s);
    const bool breaks = state_.time_s >= params_.second_breaks_s && robots() > 1 && state_.robots[1].bodies < 3.0;
    if (breaks) throw Diverged{state_.time_s, 0, "its neighbour broke"};
  }
  void set_joint_targets(std::size_t robot, std::span<const double> targets_rad) {
    One& one = state_.robots.at(robot);
    if (targets_rad.size() != one.targets_rad.size()) throw std::invalid_argument{"joint targets of another body"};
    const double step_m = 0.1 * std::abs(targets_rad.front() - one.targets_rad.front());
    if (std::hypot(one.x_m, one.y_m) < 10.0) {
      one.x_m += step_m * std::cos(one.yaw_rad);
      one.y_m += step_m * std::sin(one.yaw_rad);
    }
    one.targets_rad.assign(targets_rad.begin(), targets_rad.end());
    for (const double target_rad : targets_rad) {
      if (std::abs(target_rad) > params_.breaks_beyond_rad) throw Diverged{state_.time_s, robot, "a toy broke"};
    }
  }
  void embody(std::size_t robot, const RobotModel& model, const Pose& pose) {
    models_.at(robot) = model;
    const double bodies = state_.robots.at(robot).bodies;
    state_.robots[robot] = at_rest(model, pose);
    state_.robots[robot].bodies = bodies + 1.0;
  }

  [[nodiscard]] const RobotModel& model(std::size_t robot) const { return models_.at(robot); }
  [[nodiscard]] std::size_t robots() const { return models_.size(); }
  [[nodiscard]] double time_s() const { return state_.time_s; }
  [[nodiscard]] Pose pose(std::size_t robot) const {
    const One& one = state_.robots.at(robot);
    return {{one.x_m, one.y_m, one.z_m}, Eigen::Quaterniond{Eigen::AngleAxisd{one.yaw_rad, Eigen::Vector3d::UnitZ()}}};
  }
  [[nodiscard]] std::span<const double> joint_angles(std::size_t robot) const { return state_.robots.at(robot).targets_rad; }
  [[nodiscard]] State save() const { return state_; }
  void restore(const State& state) {
    for (std::size_t i = 0; i < robots(); ++i) {
      const bool same = state.robots.size() == robots() && state.robots[i].targets_rad.size() == models_[i].hinges.size();
      if (!same) throw std::invalid_argument{"a state of other bodies"};
    }
    state_ = state;
  }

 private:
  [[nodiscard]] static One at_rest(const RobotModel& model, const Pose& pose) {
    const Eigen::Vector3d ahead = pose.orientation * Eigen::Vector3d::UnitX();
    return {pose.position_m.x(), pose.position_m.y(), pose.position_m.z(), std::atan2(ahead.y(), ahead.x()),
            std::vector<double>(model.hinges.size())};
  }

  Params params_;
  std::vector<RobotModel> models_;
  State state_;
};
static_assert(Embodying<ToyBodies>);

}  // namespace trophic::test
