// SPDX-License-Identifier: MIT
// Definitions of metric_choice.hpp.
#include <tools/analysis/metrics/metric_choice.hpp>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <tools/command/words.hpp>

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
    std::vector<std::string> words;
    std::string all;
    for (const MetricName& name : names) {
      if (std::ranges::find(words, name.metric) == words.end()) {
        all += (all.empty() ? "" : ", ") + name.metric;
        words.push_back(name.metric);
      }
      words.push_back(name.metric + ":" + name.species);
      words.push_back(name.metric + ":" + name.species + ":" + name.group);
    }
    throw std::invalid_argument{"metric " + choice + ": must be METRIC, METRIC:SPECIES or METRIC:SPECIES:GROUP of " + all +
                                command::did_you_mean(command::nearest_word(choice, words))};
  }
  std::vector<MetricName> found;
  for (const MetricName& name : names) {
    const auto is_named = [&](const std::string& choice) { return chooses(choice, name); };
    if (choices.empty() || std::ranges::any_of(choices, is_named)) found.push_back(name);
  }
  return found;
}

}  // namespace trophic::analysis
