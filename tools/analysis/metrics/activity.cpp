// SPDX-License-Identifier: MIT
// Definitions of activity.hpp.
#include <tools/analysis/metrics/activity.hpp>

#include <algorithm>
#include <cstddef>
#include <unordered_map>

namespace trophic::analysis {

namespace {

/// Activity of types that have been present.
using Counters = std::unordered_map<Type, double>;

void count_present(const std::vector<Type>& present, Counters& counters) {
  for (const Type type : present) counters[type] += 1.0;
}

/// The activity that 95 % of the types of the nulls do not exceed in the end.
double threshold_of(std::span<const Presence> nulls) {
  std::vector<double> reached;
  for (const Presence& null : nulls) {
    Counters counters;
    for (const std::vector<Type>& present : null) count_present(present, counters);
    for (const auto& [type, activity] : counters) reached.push_back(activity);
  }
  if (reached.empty()) return 0.0;
  const auto place = static_cast<std::ptrdiff_t>((reached.size() * 95 + 99) / 100 - 1);
  std::ranges::nth_element(reached, reached.begin() + place);
  return reached[static_cast<std::size_t>(place)];
}

}  // namespace

Presence presence_of(const Forest& forest, Species species, std::span<const Type> types, std::span<const double> times_s) {
  Presence presence(times_s.size());
  for (std::size_t place = 0; place < forest.size(); ++place) {
    const Taxon& taxon = forest[place];
    if (taxon.species != species) continue;
    auto time = std::ranges::lower_bound(times_s, taxon.birth_s);
    for (; time != times_s.end() && *time < taxon.death_s; ++time) {
      presence[static_cast<std::size_t>(time - times_s.begin())].push_back(types[place]);
    }
  }
  for (std::vector<Type>& present : presence) {
    std::ranges::sort(present);
    present.erase(std::unique(present.begin(), present.end()), present.end());
  }
  return presence;
}

std::vector<Activity> activity_of(const Presence& presence, std::span<const Presence> nulls) {
  const double threshold = threshold_of(nulls);
  Counters own;
  std::vector<Counters> others(nulls.size());
  std::vector<Activity> result;
  for (std::size_t i = 0; i < presence.size(); ++i) {
    count_present(presence[i], own);
    for (std::size_t k = 0; k < nulls.size(); ++k) count_present(nulls[k][i], others[k]);
    Activity now{.diversity = static_cast<double>(presence[i].size())};
    for (const Type type : presence[i]) {
      const double activity = own[type];
      double null = 0.0;
      for (const Counters& other : others) {
        const auto found = other.find(type);
        if (found != other.end()) null += found->second / static_cast<double>(others.size());
      }
      now.mean += activity / now.diversity;
      now.excess += std::max(0.0, activity - null) / now.diversity;
      if (activity > threshold && activity - 1.0 <= threshold) now.fresh += 1.0;
    }
    result.push_back(now);
  }
  return result;
}

}  // namespace trophic::analysis
