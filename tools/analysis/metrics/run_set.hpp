// SPDX-License-Identifier: MIT
// Runs that belong together, measured, with the shadow that they are set beside.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <tools/analysis/data/pooled_runs.hpp>
#include <tools/analysis/metrics/measurement.hpp>
#include <vector>

namespace trophic::analysis {

/// Runs of one fingerprint with what was measured in each.
struct RunSet {
  std::string label;                   ///< name of the rule table
  std::vector<RunManifest> manifests;  ///< one per run
  std::vector<RunMetrics> runs;        ///< in the order of `manifest`
  std::vector<std::string> remarks;
};

/// Reads and measures runs that may be pooled; with `until_s`, only their first seconds. Throws as pooled_runs and read_run do,
/// and std::invalid_argument for a run that is shorter than `until_s`.
[[nodiscard]] RunSet read_set(std::span<const std::filesystem::path> paths, std::optional<double> until_s = {},
                              bool any_build = false);

/// A set with its shadow, where there is one.
struct ShadowedSet {
  RunSet ours;
  std::optional<RunSet> shadow;
  /// The shadow's runs; none without one.
  [[nodiscard]] std::span<const RunMetrics> shadow_runs() const;
};

/// Reads a set and its shadow: `elsewhere`, or else what shadow_folders finds. Throws as read_set and check_shadow do, and
/// std::invalid_argument if another build made the shadow, unless `any_build`.
[[nodiscard]] ShadowedSet read_shadowed_set(std::span<const std::filesystem::path> paths,
                                            const std::optional<std::filesystem::path>& elsewhere = {},
                                            std::optional<double> until_s = {}, bool any_build = false);

}  // namespace trophic::analysis
