// SPDX-License-Identifier: MIT
// Definitions of sweep_json.hpp.
#include <tools/analysis/report/sweep_json.hpp>

#include <optional>
#include <tools/analysis/data/sweep_grid.hpp>
#include <tools/analysis/report/summary_json.hpp>
#include <tools/analysis/statistics/interval.hpp>
#include <tools/analysis/statistics/power.hpp>

namespace trophic::analysis {

Json sweep_json(const SweepRuns& sweep, const CellDifferences& differences, std::size_t reference,
                std::span<const RunsForDifference> answers) {
  Json json;
  json["cells"] = sweep.grid.cells.size();
  json["runs_planned"] = sweep.plan.size();
  json["missing"] = sweep.missing;
  json["builds"] = sweep.builds;
  json["axes"] = Json::array();
  for (const Axis& axis : sweep.grid.axes) json["axes"].push_back({{"name", axis.name}, {"values", axis.values}});
  json["reference"] = reference;
  json["min_runs_for_test"] = min_runs_for_test;
  json["comparisons"] = differences.comparisons;
  json["level"] = differences.level();
  json["power"] = usual_power;
  json["significant"] = Json::array();
  for (const CellDifference& d : differences.all) {
    if (!d.difference.differs()) continue;
    Json entry{{"cell", d.cell}};
    detail::put(entry, d.name);
    entry["over_shadow"] = d.over_shadow;
    detail::put(entry, d.difference);
    entry["hedges_g"] = detail::to_json(d.hedges_g);
    json["significant"].push_back(entry);
  }
  json["asked"] = Json::array();
  for (const RunsForDifference& answer : answers) {
    Json entry;
    detail::put(entry, answer.name);
    entry["difference"] = answer.difference;
    entry["over_shadow"] = answer.over_shadow;
    const auto count = [](const std::optional<std::size_t>& runs) { return runs ? Json(*runs) : Json(); };
    entry["runs"] = count(answer.runs);
    entry["fewest"] = count(answer.fewest);
    entry["most"] = count(answer.most);
    json["asked"].push_back(entry);
  }
  return json;
}

}  // namespace trophic::analysis
