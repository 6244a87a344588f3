// SPDX-License-Identifier: MIT
// Where a robot went in a trial, and what can be measured on it.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <trophic/support/units.hpp>
#include <vector>

namespace trophic::gait_evolution {

/// The ground poses of one robot, at the start and after every control step.
struct Track {
  double control_hz = 60.0;
  std::vector<GroundPose> poses;  ///< at least one

  [[nodiscard]] double duration_s() const { return static_cast<double>(poses.size() - 1) / control_hz; }

  /// How far the robot got towards the negative x-axis, m.
  [[nodiscard]] double displacement_minus_x_m() const { return poses.front().x_m - poses.back().x_m; }

  /// Distance between start and end, m.
  [[nodiscard]] double displacement_m() const { return distance_m(poses.front(), poses.back()); }

  /// The headings as one continuous curve that begins at 0: whole turns counted, counter-clockwise positive.
  [[nodiscard]] std::vector<double> turned_rad() const {
    std::vector<double> turned{0.0};
    for (std::size_t i = 1; i < poses.size(); ++i) {
      turned.push_back(turned.back() + wrap_angle(poses[i].heading_rad - poses[i - 1].heading_rad));
    }
    return turned;
  }

  /// Slope of the straight line that fits the heading best (least squares): legs make a body swing, ends alone would mislead.
  /// Counter-clockwise positive. At least two poses.
  [[nodiscard]] double turn_rate_rad_s() const {
    const std::vector<double> turned = turned_rad();
    const double middle = static_cast<double>(turned.size() - 1) / 2.0;
    double sum_kt = 0.0;
    double sum_kk = 0.0;
    for (std::size_t i = 0; i < turned.size(); ++i) {
      const double k = static_cast<double>(i) - middle;
      sum_kt += k * turned[i];
      sum_kk += k * k;
    }
    return sum_kt / sum_kk * control_hz;
  }

  /// Mean speed along the heading (first) and to its left (second): way made in each window of that length, seen along the mean
  /// heading in it. The track is longer than a window.
  [[nodiscard]] std::array<double, 2> forward_and_left_m_s(double window_s = 5.0) const {
    const auto window = static_cast<std::size_t>(std::llround(window_s * control_hz));
    double forward_m = 0.0;
    double left_m = 0.0;
    for (std::size_t first = 0; first + window < poses.size(); ++first) {
      double ahead_x = 0.0;
      double ahead_y = 0.0;
      for (std::size_t i = first; i <= first + window; ++i) {
        ahead_x += std::cos(poses[i].heading_rad);
        ahead_y += std::sin(poses[i].heading_rad);
      }
      const double norm = std::hypot(ahead_x, ahead_y);
      const double dx = poses[first + window].x_m - poses[first].x_m;
      const double dy = poses[first + window].y_m - poses[first].y_m;
      forward_m += (dx * ahead_x + dy * ahead_y) / norm;
      left_m += (dy * ahead_x - dx * ahead_y) / norm;
    }
    const double total_s = static_cast<double>((poses.size() - window) * window) / control_hz;
    return {forward_m / total_s, left_m / total_s};
  }
};

}  // namespace trophic::gait_evolution
