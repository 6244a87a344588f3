// SPDX-License-Identifier: MIT
// The state of every robot between two calls of MuJoCo, robot by robot, independent of the models.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <trophic/backend/mujoco/compiled_model.hpp>
#include <trophic/support/units.hpp>
#include <vector>

namespace trophic::backend::mujoco {

/// No robot is designed to be faster; with too long a timestep one soon is. Such robots would need discs so wide that all of
/// them become one MuJoCo group, which takes minutes and all memory.
inline constexpr double fastest_m_s = 100.0;

/// Per robot one row: generalized positions (root x, y, z, quaternion w, x, y, z, then angles in MuJoCo's order), velocities
/// (root linear in the world's frame, angular in the root's, then angles), and the accelerations from which the solver starts
/// next.
class RobotStates {
 public:
  RobotStates(const Layout& layout, std::size_t robots)
      : layout_{layout}, width_{layout.positions + 2 * layout.velocities}, values_(robots * width_) {}

  [[nodiscard]] std::size_t robots() const { return width_ == 0 ? 0 : values_.size() / width_; }
  [[nodiscard]] const std::vector<double>& values() const { return values_; }
  void set_values(const std::vector<double>& values) { values_ = values; }

  /// A robot's whole row.
  [[nodiscard]] std::span<double> numbers(std::size_t robot) { return {row(robot), width_}; }
  [[nodiscard]] std::span<const double> numbers(std::size_t robot) const { return {row(robot), width_}; }

  [[nodiscard]] std::span<double> positions(std::size_t robot) { return {row(robot), layout_.positions}; }
  [[nodiscard]] std::span<const double> positions(std::size_t robot) const { return {row(robot), layout_.positions}; }
  [[nodiscard]] std::span<const double> velocities(std::size_t robot) const {
    return {row(robot) + layout_.positions, layout_.velocities};
  }

  void set_root(std::size_t robot, const Pose& pose) {
    const Eigen::Quaterniond q = pose.orientation.normalized();
    const std::array<double, 7> root{pose.position_m.x(), pose.position_m.y(), pose.position_m.z(), q.w(), q.x(), q.y(), q.z()};
    std::ranges::copy(root, row(robot));
  }

  [[nodiscard]] Pose root(std::size_t robot) const {
    const double* p = row(robot);
    return {{p[0], p[1], p[2]}, Eigen::Quaterniond{p[3], p[4], p[5], p[6]}};
  }

  /// Copies a robot's row into the `share`-th share of MuJoCo's arrays.
  void load(std::size_t robot, std::size_t share, mjData& data) const {
    const double* from = row(robot);
    const std::size_t nq = layout_.positions;
    const std::size_t nv = layout_.velocities;
    std::copy_n(from, nq, data.qpos + share * nq);
    std::copy_n(from + nq, nv, data.qvel + share * nv);
    std::copy_n(from + nq + nv, nv, data.qacc_warmstart + share * nv);
  }

  /// Copies a share back into a robot's row. Returns false if a number is not finite or larger than MuJoCo accepts.
  [[nodiscard]] bool store(std::size_t robot, std::size_t share, const mjData& data) {
    double* to = row(robot);
    const std::size_t nq = layout_.positions;
    const std::size_t nv = layout_.velocities;
    std::copy_n(data.qpos + share * nq, nq, to);
    std::copy_n(data.qvel + share * nv, nv, to + nq);
    std::copy_n(data.qacc_warmstart + share * nv, nv, to + nq + nv);
    return sound(robot);
  }

  /// The speed of a robot's root, m/s.
  [[nodiscard]] double speed_m_s(std::size_t robot) const {
    const std::span<const double> velocity = velocities(robot);
    return std::hypot(velocity[0], velocity[1], velocity[2]);
  }

  /// Whether a robot's numbers are finite and not larger than MuJoCo accepts.
  [[nodiscard]] bool sound(std::size_t robot) const {
    return std::ranges::all_of(numbers(robot), [](double value) { return std::abs(value) <= mjMAXVAL; });
  }

 private:
  [[nodiscard]] double* row(std::size_t robot) { return values_.data() + robot * width_; }
  [[nodiscard]] const double* row(std::size_t robot) const { return values_.data() + robot * width_; }

  Layout layout_;
  std::size_t width_;
  std::vector<double> values_;
};

}  // namespace trophic::backend::mujoco
