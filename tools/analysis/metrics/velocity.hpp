// SPDX-License-Identifier: MIT
// Velocity: how fast robots get nearer to where their adversary was.
#pragma once

#include <cstdint>
#include <tools/analysis/metrics/series.hpp>
#include <tools/reading/tables.hpp>
#include <vector>

namespace trophic::analysis {

/// One robot over one stretch of time: (dist(P1, A1) - dist(P2, A1)) / duration with P1, P2 its own position at the start and the
/// end and A1 its adversary's at the start; positive towards the adversary (Eq. 6 of Sec. "Metrics for system dynamics"). A walk
/// past something close ends farther away on average, so the null is the neutral shadow, not zero.
struct VelocitySample {
  double time_s = 0.0;  ///< start
  double end_s = 0.0;
  Species species = 0;
  Origin origin = Origin::random;
  bool active = true;  ///< at the start
  double velocity_m_s = 0.0;
};

/// A stretch of the paper: 12 s.
inline constexpr std::int64_t velocity_ticks = 6;

/// Every stretch of `ticks` ticks of every robot that has an adversary at its start, one starting
/// at each tick. The adversary may die meanwhile: only its position at the start counts. If the robot dies meanwhile, there is no
/// sample; nor are there any in the last `ticks` ticks.
[[nodiscard]] std::vector<VelocitySample> velocity_samples(Agents agents, std::int64_t ticks = velocity_ticks);

/// As velocity_samples, with the adversary that the authors' log stores: for each body the body that it last perceived as
/// closest, kept across births and while it perceives none. Bodies that have never perceived another give no sample. The
/// published velocities come from such a log. Needs the rows of every tick, because another body may be perceived at a tick left
/// out.
[[nodiscard]] std::vector<VelocitySample> stored_velocity_samples(Agents agents, std::int64_t ticks = velocity_ticks);

/// Samples of the stretches that end at a mark: at the first tick of `agents` at or after `every_s`, 2 `every_s`, ..., and at
/// which a stretch ends. The paper's "population averages measured every 200 seconds, resulting in 30 points" may be these
/// instead of means over windows: a stretch's velocity is measured when it ends, and 200, 400, ..., 6000 s are 30 marks, while
/// no stretch that begins at 6000 s can be measured.
[[nodiscard]] std::vector<VelocitySample> samples_at_marks(const std::vector<VelocitySample>& samples, Agents agents,
                                                           double every_s = 200.0, std::int64_t ticks = velocity_ticks);

/// Velocity of a group, averaged in windows of `window_s` (200 s in the paper: 30 points). Its mean_of_points() is the straight
/// line in the paper's figure.
[[nodiscard]] WindowMean velocity(const std::vector<VelocitySample>& samples, Species species, Group group,
                                  double window_s = 200.0);

}  // namespace trophic::analysis
