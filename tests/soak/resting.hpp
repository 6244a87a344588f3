// SPDX-License-Identifier: MIT
// Robots at rest must not gain energy, in runs of any length.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <span>
#include <trophic/habitat/habitat.hpp>
#include <trophic/habitat/physics.hpp>
#include <trophic/habitat/pose.hpp>
#include <trophic/habitat/robot_model.hpp>
#include <trophic/observe/frame.hpp>
#include <trophic/params/archive.hpp>

namespace trophic::test {

/// A habitat whose robots stand still for any gait and steering.
[[nodiscard]] inline Habitat at_rest(Habitat habitat) {
  for (Hinge& hinge : habitat.robot.hinges) hinge.servo.target_limit_rad = 1e-9;
  return habitat;
}

/// Throws std::logic_error as soon as a robot has more mechanical energy, or lies elsewhere, than when it had come to rest: m g z
/// of its root, with half of m v^2 for the root's mean velocity since the frame before.
class Resting {
 public:
  /// To come to rest, in simulated seconds.
  static constexpr double settles_s = 60.0;

  /// What robots may gain and how far they may move; the default is for an engine without creep.
  explicit Resting(double highest_gain_J = 1e-6, double highest_drift_m = 1e-6)
      : highest_gain_J_{highest_gain_J}, highest_drift_m_{highest_drift_m} {}

  [[nodiscard]] static double frame_hz() { return 1.0; }

  void on_frame(const observe::Frame& frame) { see(frame.time_s * frame.times.clock_scale, frame.roots, frame.robot); }

  /// The root links' poses at a moment, in simulated seconds.
  void see(double now_s, std::span<const Pose> roots, const RobotModel& robot) {
    if (now_s < settles_s) return;
    const Positions now_m = positions_of(roots);
    if (rest_m_.empty()) rest_m_ = now_m;
    if (!before_m_.empty() && now_s > before_s_) look_at(now_m, now_s - before_s_, mass_kg(robot));
    before_m_ = now_m;
    before_s_ = now_s;
  }

  static constexpr std::string_view section = "resting";  ///< of a checkpoint
  void persist(Archive& archive) { archive(rest_m_, before_m_, before_s_, gain_J_, drift_m_); }

  /// The most that a robot had beyond its energy at rest, J.
  [[nodiscard]] double gain_J() const { return gain_J_; }
  /// The farthest that a robot lay from where it came to rest, m.
  [[nodiscard]] double drift_m() const { return drift_m_; }

 private:
  using Positions = std::vector<std::array<double, 3>>;

  [[nodiscard]] static Positions positions_of(std::span<const Pose> roots) {
    Positions positions_m;
    for (const Pose& root : roots) positions_m.push_back({root.position_m.x(), root.position_m.y(), root.position_m.z()});
    return positions_m;
  }

  [[nodiscard]] static double mass_kg(const RobotModel& robot) {
    double sum_kg = 0.0;
    for (const Link& link : robot.links) sum_kg += link.mass_kg;
    return sum_kg;
  }

  void look_at(const Positions& now_m, double since_s, double mass_kg) {
    for (std::size_t body = 0; body < now_m.size(); ++body) {
      const Eigen::Vector3d here_m{now_m[body].data()};
      const Eigen::Vector3d from_rest_m = here_m - Eigen::Vector3d{rest_m_[body].data()};
      const double speed_mps = (here_m - Eigen::Vector3d{before_m_[body].data()}).norm() / since_s;
      gain_J_ = std::max(gain_J_, mass_kg * (Physics{}.gravity_m_s2 * from_rest_m.z() + speed_mps * speed_mps / 2.0));
      drift_m_ = std::max(drift_m_, from_rest_m.head<2>().norm());
    }
    if (!(gain_J_ <= highest_gain_J_)) throw std::logic_error{"a robot at rest has gained " + std::to_string(gain_J_) + " J"};
    if (!(drift_m_ <= highest_drift_m_)) throw std::logic_error{"a robot at rest has moved " + std::to_string(drift_m_) + " m"};
  }

  double highest_gain_J_;
  double highest_drift_m_;
  Positions rest_m_;
  Positions before_m_;
  double before_s_ = 0.0;
  double gain_J_ = 0.0;
  double drift_m_ = 0.0;
};

}  // namespace trophic::test
