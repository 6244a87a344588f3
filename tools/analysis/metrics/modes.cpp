// SPDX-License-Identifier: MIT
// Definitions of modes.hpp.
#include <tools/analysis/metrics/modes.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace trophic::analysis {

std::vector<std::size_t> persistent(const Forest& forest, Species species, double start_s, double end_s) {
  std::set<std::size_t> kept;
  for (std::size_t place = 0; place < forest.size(); ++place) {
    if (forest[place].species != species || !forest[place].lives_at(end_s)) continue;
    std::optional<std::size_t> ancestor = place;
    while (ancestor && !forest[*ancestor].lives_at(start_s)) ancestor = forest[*ancestor].parent;
    if (ancestor) kept.insert(*ancestor);
  }
  return {kept.begin(), kept.end()};
}

std::vector<Modes> modes_of(const Forest& forest, Species species, std::span<const Type> types, std::span<const double> times_s,
                            const std::function<double(std::size_t place)>& complexity) {
  std::vector<Modes> windows;
  std::set<Type> before;
  std::set<Type> ever;
  for (std::size_t i = 1; i < times_s.size(); ++i) {
    Modes window{.time_s = times_s[i], .change = {}, .novelty = {}, .ecology = {}, .complexity = {}};
    const std::vector<std::size_t> kept = persistent(forest, species, times_s[i - 1], times_s[i]);
    std::map<Type, double> counts;
    for (const std::size_t place : kept) {
      counts[types[place]] += 1.0;
      window.complexity = std::max(window.complexity.value_or(0.0), complexity(place));
    }
    std::set<Type> now;
    double change = 0.0;
    double novelty = 0.0;
    double entropy = 0.0;
    for (const auto& [type, count] : counts) {
      now.insert(type);
      if (!before.contains(type)) change += 1.0;
      if (ever.insert(type).second) novelty += 1.0;
      const double share = count / static_cast<double>(kept.size());
      entropy -= share * std::log2(share);
    }
    if (i > 1) {
      window.change = change;
      window.novelty = novelty;
    }
    if (!kept.empty()) window.ecology = entropy;
    before = std::move(now);
    windows.push_back(window);
  }
  return windows;
}

}  // namespace trophic::analysis
