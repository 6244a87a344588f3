// SPDX-License-Identifier: MIT
// The state of every robot between two calls of MuJoCo, robot by robot, independent of the models.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <trophic/backend/mujoco/compiled_model.hpp>
#include <trophic/backend/mujoco/rows.hpp>
#include <trophic/support/units.hpp>
#include <vector>

namespace trophic::backend::mujoco {

/// No robot is designed to be faster, but too long a time step soon makes one faster. Such robots would need discs so wide that
/// all of them become one MuJoCo group, which takes minutes and all memory.
inline constexpr double fastest_m_s = 100.0;

/// The reason for rejecting a robot that moves unphysically fast.
[[nodiscard]] inline std::string too_fast() {
  return "it is faster than " + number_text(fastest_m_s) + " m/s; physics.timestep_s may be too long";
}

/// Per robot one row: generalized positions (root x, y, z, quaternion w, x, y, z, then angles in MuJoCo's order), velocities
/// (root linear in the world's frame, angular in the root's, then angles), and the accelerations from which the solver starts
/// next; and the number of its body's kind, and whether the robot is in the world. No coordinate may be beyond `extent_m`.
class RobotStates {
 public:
  RobotStates(const Layout& layout, std::size_t robots, double extent_m = std::numeric_limits<double>::infinity())
      : extent_m_{extent_m}, rows_{robots, layout.positions + 2 * layout.velocities}, kinds_(robots), is_there_(robots, true) {}

  [[nodiscard]] std::size_t robots() const { return rows_.size(); }
  [[nodiscard]] const std::vector<double>& values() const { return rows_.values(); }
  void set_values(const std::vector<double>& values) { rows_.set_values(values); }

  /// Gives a robot a different body, with angles 0 and at rest. Its root must be set next.
  void set_body(std::size_t robot, std::size_t kind, const Layout& layout) {
    rows_.reset(robot, layout.positions + 2 * layout.velocities);
    kinds_[robot] = kind;
  }
  [[nodiscard]] std::size_t kind(std::size_t robot) const { return kinds_[robot]; }

  [[nodiscard]] bool is_there(std::size_t robot) const { return is_there_[robot]; }
  void set_there(std::size_t robot, bool is_there) { is_there_[robot] = is_there; }
  /// The robots that are not in the world, in ascending order.
  [[nodiscard]] std::vector<std::uint64_t> absent() const {
    std::vector<std::uint64_t> robots;
    for (std::size_t robot = 0; robot < is_there_.size(); ++robot) {
      if (!is_there_[robot]) robots.push_back(robot);
    }
    return robots;
  }
  /// Throws std::out_of_range for a robot that does not exist.
  void set_absent(std::span<const std::uint64_t> robots) {
    is_there_.assign(is_there_.size(), true);
    for (const std::uint64_t robot : robots) is_there_.at(robot) = false;
  }

  [[nodiscard]] std::span<double> numbers(std::size_t robot) { return rows_[robot]; }
  [[nodiscard]] std::span<const double> numbers(std::size_t robot) const { return rows_[robot]; }

  [[nodiscard]] std::span<double> positions(std::size_t robot) { return rows_[robot].first(velocities_of(robot) + 1); }
  [[nodiscard]] std::span<const double> positions(std::size_t robot) const {
    return rows_[robot].first(velocities_of(robot) + 1);
  }
  [[nodiscard]] std::span<const double> velocities(std::size_t robot) const {
    const std::size_t count = velocities_of(robot);
    return rows_[robot].subspan(count + 1, count);
  }

  void set_root(std::size_t robot, const Pose& pose) {
    const Eigen::Quaterniond q = pose.orientation.normalized();
    const std::array<double, 7> root{pose.position_m.x(), pose.position_m.y(), pose.position_m.z(), q.w(), q.x(), q.y(), q.z()};
    std::ranges::copy(root, rows_[robot].begin());
  }

  [[nodiscard]] Pose root(std::size_t robot) const {
    const double* p = rows_[robot].data();
    return {{p[0], p[1], p[2]}, Eigen::Quaterniond{p[3], p[4], p[5], p[6]}};
  }

  /// Copies a robot's row into its share of MuJoCo's arrays.
  void load(std::size_t robot, const Share& share, mjData& data) const {
    const double* from = rows_[robot].data();
    const std::size_t nv = velocities_of(robot);
    const std::size_t nq = nv + 1;
    std::copy_n(from, nq, data.qpos + share.position);
    std::copy_n(from + nq, nv, data.qvel + share.velocity);
    std::copy_n(from + nq + nv, nv, data.qacc_warmstart + share.velocity);
  }

  void store(std::size_t robot, const Share& share, const mjData& data) {
    double* to = rows_[robot].data();
    const std::size_t nv = velocities_of(robot);
    const std::size_t nq = nv + 1;
    std::copy_n(data.qpos + share.position, nq, to);
    std::copy_n(data.qvel + share.velocity, nv, to + nq);
    std::copy_n(data.qacc_warmstart + share.velocity, nv, to + nq + nv);
  }

  /// Why a robot's position or speed is impossible; empty if it is possible.
  [[nodiscard]] std::string fault(std::size_t robot) const {
    const auto accepted = [](double value) { return std::abs(value) <= mjMAXVAL; };  // by MuJoCo
    if (!std::ranges::all_of(numbers(robot), accepted)) return "a number is NaN or too large";
    const double* p = rows_[robot].data();
    if (std::max({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])}) > extent_m_)
      return "its position is beyond +-" + number_text(extent_m_) + " m";
    const std::span<const double> velocity = velocities(robot);
    return std::hypot(velocity[0], velocity[1], velocity[2]) > fastest_m_s ? too_fast() : std::string{};
  }

 private:
  /// A row has one number more for positions than for velocities: the root's quaternion.
  [[nodiscard]] std::size_t velocities_of(std::size_t robot) const { return (rows_[robot].size() - 1) / 3; }

  double extent_m_;
  Rows rows_;
  std::vector<std::size_t> kinds_;
  std::vector<bool> is_there_;
};

}  // namespace trophic::backend::mujoco
