// SPDX-License-Identifier: MIT
// Velocity: how fast robots get nearer to where their adversary was.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <trophic/measure/series.hpp>
#include <trophic/measure/tables.hpp>
#include <vector>

namespace trophic::measure {

/// One robot over one stretch of time: (dist(P1, A1) - dist(P2, A1)) / duration with P1, P2 its own position at the start and the
/// end and A1 its adversary's at the start (Eq. "eqvelo"); positive towards the adversary. Beside it what the same walk would
/// have given with another adversary.
struct VelocitySample {
  double time_s = 0.0;  ///< start
  Species species = 0;
  Origin origin = Origin::random;
  double velocity_m_s = 0.0;
  double shuffled_m_s = 0.0;  ///< expectation for an adversary drawn at random among all opponents alive at the start
  double turned_m_s = 0.0;    ///< expectation for an adversary at the true distance in a random direction
};

/// The true adversary is the closest one; a walk past something close ends farther away on average, by about s^2 / (4 d) for a
/// walk of s at distance d. `turned` has this bias, `shuffled` has what the arena's shape does; the paper corrects for neither.
enum class VelocityNull { none, shuffled, turned };

/// Every stretch of `ticks` ticks (6, that is 12 s, in the paper) of every robot that has an adversary at its start, one starting
/// at each tick. The adversary may die meanwhile: only its position at the start counts. A robot that is reborn meanwhile is
/// somebody else: no sample; nor are there any in the last `ticks` ticks.
[[nodiscard]] inline std::vector<VelocitySample> velocity_samples(Agents agents, const FoodWeb& web, std::int64_t ticks = 6) {
  const auto distance = [](double ax_m, double ay_m, const AgentRow& b) { return std::hypot(b.x_m - ax_m, b.y_m - ay_m); };
  std::vector<VelocitySample> samples;
  const auto moments = by_tick(agents);
  std::size_t later = 0;
  for (const Agents& now : moments) {
    while (later < moments.size() && moments[later].front().tick < now.front().tick + ticks) ++later;
    if (later == moments.size() || moments[later].front().tick != now.front().tick + ticks) continue;
    const Moment start{now};
    const Moment end{moments[later]};
    for (const AgentRow& from : now) {
      const AgentRow* to = end.find(from.id);
      const AgentRow* adversary = from.adversary ? start.find(*from.adversary) : nullptr;
      if (to == nullptr || adversary == nullptr) continue;
      const double duration_s = to->time_s - from.time_s;
      const auto nearer_m = [&](const AgentRow& a) { return distance(from.x_m, from.y_m, a) - distance(to->x_m, to->y_m, a); };

      Mean shuffled;
      for (const AgentRow& other : now) {
        if (web.opponents(from.species, other.species)) shuffled.add(nearer_m(other));
      }
      const double walk_m = distance(from.x_m, from.y_m, *to);
      const double range_m = distance(from.x_m, from.y_m, *adversary);
      Mean turned;
      constexpr int directions = 32;
      for (int k = 0; k < directions; ++k) {
        const double angle_rad = 2.0 * std::numbers::pi * (k + 0.5) / directions;
        turned.add(range_m - std::hypot(range_m * std::cos(angle_rad) - walk_m, range_m * std::sin(angle_rad)));
      }
      samples.push_back({.time_s = from.time_s,
                         .species = from.species,
                         .origin = from.origin,
                         .velocity_m_s = nearer_m(*adversary) / duration_s,
                         .shuffled_m_s = shuffled.value().value_or(0.0) / duration_s,
                         .turned_m_s = turned.value().value_or(0.0) / duration_s});
    }
  }
  return samples;
}

/// Velocity of a group, averaged in windows of `window_s` (200 s in the paper: 30 points). Its mean_of_points() is the straight
/// line in the paper's figure.
[[nodiscard]] inline WindowMean velocity(const std::vector<VelocitySample>& samples, Species species, Group group,
                                         VelocityNull null = VelocityNull::none, double window_s = 200.0) {
  WindowMean mean{window_s};
  for (const VelocitySample& sample : samples) {
    if (sample.species != species || !belongs(sample.origin, group)) continue;
    mean.add(sample.time_s, null == VelocityNull::none       ? sample.velocity_m_s
                            : null == VelocityNull::shuffled ? sample.shuffled_m_s
                                                             : sample.turned_m_s);
  }
  return mean;
}

}  // namespace trophic::measure
