// SPDX-License-Identifier: MIT
// Definitions of metrics_table.hpp.
#include <tools/analysis/report/metrics_table.hpp>

#include <tools/analysis/report/summary.hpp>
#include <tools/analysis/report/table_file.hpp>

namespace trophic::analysis {

namespace {

/// Calls `write_row(row)` for each row, and `end_run()` after those of a run.
template <class WriteRow, class EndRun>
void for_each_row(std::span<const ShadowedSet> sets, WriteRow&& write_row, EndRun&& end_run) {
  const auto write = [&](const std::string& label, const RunSet& set, bool is_shadow) {
    for (std::size_t i = 0; i < set.runs.size(); ++i) {
      std::string run = set.manifests[i].folder.lexically_normal().filename().string();
      std::ranges::replace(run, ',', '_');
      const auto row = [&](const MetricName& name, const std::string& baseline, std::optional<double> time_s,
                           std::optional<double> value) {
        if (is_shadow && !baseline.empty()) return;  // its own baselines say nothing about the set
        write_row(MetricRow{.set = label,
                            .run = run,
                            .seed = set.manifests[i].seed,
                            .metric = name.metric,
                            .species = name.species,
                            .group = name.group,
                            .baseline = is_shadow ? std::string{shadow_name} : baseline,
                            .time_s = time_s,
                            .value = value,
                            .unit = name.unit});
      };
      for (const Measurement& measurement : set.runs[i].measurements) {
        row(measurement.name, "", {}, measurement.value);
        for (const Baseline& baseline : measurement.baselines) row(measurement.name, baseline.name, {}, baseline.value);
      }
      for (const Curve& curve : set.runs[i].curves) {
        for (const Point& point : curve.points) row(curve.name, curve.baseline, point.time_s, point.value);
      }
      end_run();
    }
  };
  for (const ShadowedSet& set : sets) {
    write(set.ours.label, set.ours, false);
    if (set.shadow) write(set.ours.label, *set.shadow, true);
  }
}

}  // namespace

void write_metrics(const std::filesystem::path& path, std::span<const ShadowedSet> sets) {
  TableFile<MetricRow> file{path};
  for_each_row(
      sets, [&](const MetricRow& row) { file.write(row); }, [&] { file.flush(); });
  file.finish();
}

std::string metrics_text(std::span<const ShadowedSet> sets) {
  const FoodWeb no_species{{}, {}};
  std::string text = io::header_of<MetricRow>();
  for_each_row(
      sets, [&](const MetricRow& row) { io::append_row(text, row, no_species); }, [] {});
  return text;
}

}  // namespace trophic::analysis
