// SPDX-License-Identifier: MIT
// Runs that belong together, measured, with the shadow that they are set beside.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <tools/analysis/data/pooled_runs.hpp>
#include <tools/analysis/data/read_run.hpp>
#include <tools/analysis/data/shadow.hpp>
#include <tools/analysis/metrics/measurement.hpp>
#include <tools/analysis/metrics/run_metrics.hpp>
#include <utility>
#include <vector>

namespace trophic::analysis {

/// Runs of one fingerprint with what was measured in each.
struct RunSet {
  std::string label;                   ///< name of the rule table
  std::vector<RunManifest> manifests;  ///< one per run
  std::vector<RunMetrics> runs;        ///< in the order of `manifest`
  std::vector<std::string> remarks;
};

/// Reads and measures runs that may be pooled; with `until_s`, only their first seconds. Throws as pooled_runs does, and
/// std::invalid_argument for a run that is shorter than `until_s`.
[[nodiscard]] inline RunSet read_set(std::span<const std::filesystem::path> paths, std::optional<double> until_s = {}) {
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

/// A set with its shadow, where there is one.
struct ShadowedSet {
  RunSet ours;
  std::optional<RunSet> shadow;
  /// The shadow's runs; none without one.
  [[nodiscard]] std::span<const RunMetrics> shadow_runs() const {
    return shadow ? std::span<const RunMetrics>{shadow->runs} : std::span<const RunMetrics>{};
  }
};

/// Reads a set and its shadow: `elsewhere`, or else what shadow_folders finds. Throws as read_set and check_shadow do.
[[nodiscard]] inline ShadowedSet read_shadowed_set(std::span<const std::filesystem::path> paths,
                                                   const std::optional<std::filesystem::path>& elsewhere = {},
                                                   std::optional<double> until_s = {}) {
  ShadowedSet set{read_set(paths, until_s), {}};
  const auto folders = elsewhere ? std::vector{*elsewhere} : shadow_folders(paths);
  if (folders.empty()) return set;
  set.shadow = read_set(folders, until_s);
  check_shadow(set.ours.manifests.front(), set.shadow->manifests.front());
  return set;
}

}  // namespace trophic::analysis
