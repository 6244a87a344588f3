// SPDX-License-Identifier: MIT
// Definitions of metric_choice.hpp.
#include <tools/analysis/metrics/metric_choice.hpp>

#include <algorithm>
#include <cstddef>
#include <stdexcept>

namespace trophic::analysis {

bool chooses(std::string_view choice, const MetricName& name) {
  for (const std::string* part : {&name.metric, &name.species, &name.group}) {
    const std::size_t end = choice.find(':');
    if (choice.substr(0, end) != *part) return false;
    if (end == std::string_view::npos) return true;
    choice.remove_prefix(end + 1);
  }
  return false;
}

std::vector<MetricName> chosen(std::span<const MetricName> names, std::span<const std::string> choices) {
  for (const std::string& choice : choices) {
    if (std::ranges::any_of(names, [&](const MetricName& name) { return chooses(choice, name); })) continue;
    std::string all;
    std::string_view last;
    for (const MetricName& name : names) {
      if (name.metric == last) continue;
      all += (all.empty() ? "" : ", ") + name.metric;
      last = name.metric;
    }
    throw std::invalid_argument{"metric " + choice + ": must be METRIC, METRIC:SPECIES or METRIC:SPECIES:GROUP of " + all};
  }
  std::vector<MetricName> found;
  for (const MetricName& name : names) {
    const auto is_named = [&](const std::string& choice) { return chooses(choice, name); };
    if (choices.empty() || std::ranges::any_of(choices, is_named)) found.push_back(name);
  }
  return found;
}

}  // namespace trophic::analysis
