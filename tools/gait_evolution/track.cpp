// SPDX-License-Identifier: MIT
// Definitions of track.hpp.
#include <tools/gait_evolution/track.hpp>

#include <cmath>
#include <cstddef>

namespace trophic::gait_evolution {

std::vector<double> Track::turned_rad() const {
  std::vector<double> turned{0.0};
  for (std::size_t i = 1; i < poses.size(); ++i) {
    turned.push_back(turned.back() + wrap_angle(poses[i].heading_rad - poses[i - 1].heading_rad));
  }
  return turned;
}

double Track::turn_rate_rad_s() const {
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

std::array<double, 2> Track::forward_and_left_m_s(double window_s) const {
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

}  // namespace trophic::gait_evolution
