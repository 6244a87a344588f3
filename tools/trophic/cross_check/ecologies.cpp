// SPDX-License-Identifier: MIT
// Definitions of ecologies.hpp.
#include <tools/trophic/cross_check/ecologies.hpp>

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <tools/analysis/statistics/equivalence.hpp>
#include <tools/reading/run_manifest.hpp>
#include <trophic/support/json.hpp>

namespace trophic::command::cross_check {

Ecologies read_ecologies(const std::filesystem::path& first, const std::filesystem::path& second) {
  Ecologies sets{analysis::read_set(std::span{&first, 1}), analysis::read_set(std::span{&second, 1})};
  const auto& a = sets.first.manifests.front();
  const auto& b = sets.second.manifests.front();
  const auto of_the_ecology = [](const analysis::RunManifest& manifest) {
    Json rest{{"rule_table", manifest.rules}, {"rules", manifest.policies}, {"params", manifest.params}};
    for (const char* own : {"seed", "physics", "backend"}) rest["params"].erase(own);
    if (rest["params"].contains("ecology")) rest["params"]["ecology"].erase("duration_s");
    return rest;
  };
  if (const std::string why = analysis::first_difference(of_the_ecology(a), of_the_ecology(b)); !why.empty()) {
    throw std::invalid_argument{second.string() + ": " + why + " as in " + first.string()};
  }
  if (!analysis::lasted_alike(a, b)) {
    throw std::invalid_argument{second.string() + ": " + analysis::lasted_text(b) + ": must be as " + analysis::lasted_text(a) +
                                ", as in " + first.string()};
  }
  return sets;
}

void compare_ecologies(const Ecologies& sets, Csv& csv) {
  const auto& manifest = sets.first.manifests.front();
  std::cout << "\n"
            << "rules " << manifest.rules << ": first " << manifest.backend << ", " << sets.first.runs.size() << " runs; second "
            << sets.second.manifests.front().backend << ", " << sets.second.runs.size() << " runs; " << manifest.until_s
            << " s each\n"
            << std::left << std::setw(40) << "metric" << std::setw(26) << "first [95 %]" << std::setw(26) << "second [95 %]"
            << std::setw(9) << "margin" << std::setw(26) << "difference [90 %]"
            << "conclusion\n";
  for (const analysis::Measurement& measured : sets.first.runs.front().measurements) {
    const analysis::MetricName& name = measured.name;
    const auto margin =
        std::ranges::find_if(margins, [&](const Margin& m) { return m.metric == name.metric && m.group == name.group; });
    if (margin == margins.end()) continue;
    const std::array values{analysis::values_of(sets.first.runs, name), analysis::values_of(sets.second.runs, name)};
    const double first_mean = std::max(1.0, analysis::mean_of(values[0]).value_or(1.0));
    const double allowed = margin->is_share_of_first ? margin->margin * first_mean : margin->margin;
    const auto test = analysis::test_equivalence(values[0], values[1], allowed);
    const bool is_velocity = name.unit == "m/s";
    const double unit = is_velocity ? 100.0 : 1.0;
    const int decimals = margin->is_share_of_first ? 1 : is_velocity ? 2 : 3;
    std::cout << std::setw(40)
              << name.metric + " " + name.species + (name.group == "all" ? "" : " (" + name.group + ")") +
                     (is_velocity ? ", cm/s" : "");
    for (std::size_t i = 0; i < 2; ++i) {
      const auto estimate = analysis::estimate(values[i]);
      std::cout << std::setw(26) << text(estimate.mean, estimate.interval, unit, decimals);
      const std::string& engine = (i == 0 ? sets.first : sets.second).manifests.front().backend;
      const Subject subject{"ecology", engine, {}, {}, {}, name.metric, name.species, name.group, name.unit};
      csv.add(subject, estimate, i == 0 ? std::nullopt : std::optional{test});
    }
    std::cout << std::setw(9) << text(unit * allowed, decimals) << std::setw(26)
              << text(test.difference, test.interval, unit, decimals) << enum_name(test.conclusion) << "\n";
  }
  for (const auto* set : {&sets.first, &sets.second}) {
    for (const std::string& remark : set->remarks) std::cout << "remark: " << remark << "\n";
  }
}

}  // namespace trophic::command::cross_check
