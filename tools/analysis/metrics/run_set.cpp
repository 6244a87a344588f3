// SPDX-License-Identifier: MIT
// Definitions of run_set.hpp.
#include <tools/analysis/metrics/run_set.hpp>

#include <stdexcept>
#include <tools/analysis/data/read_run.hpp>
#include <tools/analysis/data/shadow.hpp>
#include <tools/analysis/metrics/run_metrics.hpp>
#include <utility>

namespace trophic::analysis {

RunSet read_set(std::span<const std::filesystem::path> paths, std::optional<double> until_s, bool any_build) {
  PooledRuns pooled = pooled_runs(paths, until_s.has_value(), any_build);
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
                              std::optional<double> until_s, bool any_build) {
  ShadowedSet set{read_set(paths, until_s, any_build), {}};
  const auto folders = elsewhere ? std::vector{*elsewhere} : shadow_folders(paths);
  if (folders.empty()) return set;
  set.shadow = read_set(folders, until_s, any_build);
  const RunManifest& ours = set.ours.manifests.front();
  const RunManifest& shadow = set.shadow->manifests.front();
  check_shadow(ours, shadow);
  if (ours.builds != shadow.builds && !any_build) {
    throw std::invalid_argument{shadow.folder.string() + ": made by " + builds_text(shadow.builds) + ": must be made by " +
                                builds_text(ours.builds) + ", as " + ours.folder.string() + " (--accept-other-build takes it)"};
  }
  return set;
}

}  // namespace trophic::analysis
