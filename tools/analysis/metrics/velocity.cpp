// SPDX-License-Identifier: MIT
// Definitions of velocity.hpp.
#include <tools/analysis/metrics/velocity.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

namespace trophic::analysis {

namespace {

/// `adversary_of(row, start)` is asked of every robot at every tick, in order; a null pointer: no sample.
template <class AdversaryOf>
std::vector<VelocitySample> samples_towards(Agents agents, std::int64_t ticks, AdversaryOf adversary_of) {
  const auto distance = [](const AgentRow& a, const AgentRow& b) { return std::hypot(b.x_m - a.x_m, b.y_m - a.y_m); };
  std::vector<VelocitySample> samples;
  for (const auto& [now, later] : stretches(agents, ticks)) {
    const Moment start{now};
    const Moment end{later};
    for (const AgentRow& from : now) {
      const AgentRow* adversary = adversary_of(from, start);
      const AgentRow* to = end.find(from.id);
      if (to == nullptr || adversary == nullptr) continue;
      samples.push_back({.time_s = from.time_s,
                         .end_s = to->time_s,
                         .species = from.species,
                         .origin = from.origin,
                         .active = from.active,
                         .velocity_m_s = (distance(from, *adversary) - distance(*to, *adversary)) / (to->time_s - from.time_s)});
    }
  }
  return samples;
}

}  // namespace

std::vector<VelocitySample> velocity_samples(Agents agents, std::int64_t ticks) {
  return samples_towards(agents, ticks, [](const AgentRow& from, const Moment& start) {
    return from.adversary ? start.find(*from.adversary) : nullptr;
  });
}

std::vector<VelocitySample> stored_velocity_samples(Agents agents, std::int64_t ticks) {
  std::map<BodyIndex, BodyIndex> stored;
  return samples_towards(agents, ticks, [&stored](const AgentRow& from, const Moment& start) -> const AgentRow* {
    const AgentRow* seen = from.adversary ? start.find(*from.adversary) : nullptr;
    if (seen != nullptr) stored.insert_or_assign(from.body, seen->body);
    const auto kept = stored.find(from.body);
    return kept == stored.end() ? nullptr : start.find_body(kept->second);
  });
}

std::vector<VelocitySample> samples_at_marks(const std::vector<VelocitySample>& samples, Agents agents, double every_s,
                                             std::int64_t ticks) {
  std::set<double> marks;
  double next_s = every_s;
  for (const auto& [now, later] : stretches(agents, ticks)) {
    if (later.empty() || later.front().time_s < next_s) continue;
    marks.insert(later.front().time_s);
    next_s = (std::floor(later.front().time_s / every_s) + 1.0) * every_s;
  }
  std::vector<VelocitySample> chosen;
  std::ranges::copy_if(samples, std::back_inserter(chosen), [&](const VelocitySample& s) { return marks.contains(s.end_s); });
  return chosen;
}

WindowMean velocity(const std::vector<VelocitySample>& samples, Species species, Group group, double window_s) {
  WindowMean mean{window_s};
  for (const VelocitySample& sample : samples) {
    if (sample.species != species || !belongs(sample.origin, sample.active, group)) continue;
    mean.add(sample.time_s, sample.velocity_m_s);
  }
  return mean;
}

}  // namespace trophic::analysis
