// SPDX-License-Identifier: MIT
// Definitions of run_set.hpp.
#include <tools/analysis/metrics/run_set.hpp>

#include <tools/analysis/data/read_run.hpp>
#include <tools/analysis/data/shadow.hpp>
#include <tools/analysis/metrics/run_metrics.hpp>
#include <utility>

namespace trophic::analysis {

RunSet read_set(std::span<const std::filesystem::path> paths, std::optional<double> until_s) {
  PooledRuns pooled = pooled_runs(paths, until_s.has_value());
  RunSet set{pooled.manifests.front().rules, std::move(pooled.manifests), {}, std::move(pooled.remarks)};
  for (RunManifest& manifest : set.manifests) {
    RunData run = read_run(manifest.folder);
    if (until_s) cut_to(run, *until_s);
    manifest.until_s = run.manifest.until_s;
    if (until_s) manifest.reached_s = run.manifest.until_s;
    set.remarks.insert(set.remarks.end(), run.remarks.begin(), run.remarks.end());
    if (const std::string lost = lost_to_thinning(manifest.agents_every_ticks); !lost.empty()) {
      set.remarks.push_back(manifest.folder.string() + "/" + lost);
    }
    set.runs.push_back(measure_run(run));
  }
  return set;
}

std::span<const RunMetrics> ShadowedSet::shadow_runs() const {
  return shadow ? std::span<const RunMetrics>{shadow->runs} : std::span<const RunMetrics>{};
}

ShadowedSet read_shadowed_set(std::span<const std::filesystem::path> paths, const std::optional<std::filesystem::path>& elsewhere,
                              std::optional<double> until_s) {
  ShadowedSet set{read_set(paths, until_s), {}};
  const auto folders = elsewhere ? std::vector{*elsewhere} : shadow_folders(paths);
  if (folders.empty()) return set;
  set.shadow = read_set(folders, until_s);
  check_shadow(set.ours.manifests.front(), set.shadow->manifests.front());
  return set;
}

}  // namespace trophic::analysis
