// SPDX-License-Identifier: MIT
// The path of a robot in a trial, and its measures.
#pragma once

#include <array>
#include <trophic/support/units.hpp>
#include <vector>

namespace trophic::gait_evolution {

/// The ground poses of one robot, at the start and after every control step.
struct Track {
  double control_hz = 60.0;
  std::vector<GroundPose> poses;  ///< at least one
  double engine_share = 0.0;      ///< of the steps, those that the engine took although the backend has a faster way

  [[nodiscard]] double duration_s() const { return static_cast<double>(poses.size() - 1) / control_hz; }

  /// How far the robot got towards the negative x-axis, m.
  [[nodiscard]] double displacement_minus_x_m() const { return poses.front().x_m - poses.back().x_m; }

  /// Distance between start and end, m.
  [[nodiscard]] double displacement_m() const { return distance_m(poses.front(), poses.back()); }

  /// The headings as one continuous curve that begins at 0: whole turns counted, counter-clockwise positive.
  [[nodiscard]] std::vector<double> turned_rad() const;

  /// Slope of the straight line that fits the heading best (least squares): legs make a body swing, ends alone would mislead.
  /// Counter-clockwise positive. At least two poses.
  [[nodiscard]] double turn_rate_rad_s() const;

  /// Mean speed along the heading (first) and to its left (second): way made in each window of that length, seen along the mean
  /// heading in it. The track is longer than a window.
  [[nodiscard]] std::array<double, 2> forward_and_left_m_s(double window_s = 5.0) const;
};

}  // namespace trophic::gait_evolution
