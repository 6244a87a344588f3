// SPDX-License-Identifier: MIT
// Runs that belong together, measured, with their shadow.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <tools/analysis/metrics/lineage_metrics.hpp>
#include <tools/analysis/metrics/measurement.hpp>
#include <tools/analysis/metrics/own_column.hpp>
#include <tools/reading/pooled_runs.hpp>

namespace trophic::analysis {

/// Runs of one fingerprint with what was measured in each.
struct RunSet {
  std::string label;                   ///< name of the rule table
  std::vector<RunManifest> manifests;  ///< one per run
  std::vector<RunMetrics> runs;        ///< in the order of `manifest`
  std::vector<std::string> remarks;
};

/// How runs are measured.
struct Measuring {
  std::optional<double> until_s = {};             ///< only the first seconds
  bool any_build = false;                         ///< runs of several builds of a program may be pooled
  std::vector<OwnColumn> columns = {};            ///< metrics that are columns of tables
  std::optional<LineageMeasuring> lineages = {};  ///< lineage measures, and no others
  bool bodies = false;                            ///< measures of bodies and of users, and no others
  std::size_t jobs = 1;                           ///< runs measured at a time; results do not depend on it
  std::function<void()> on_run = {};              ///< called after each run, by any thread, one at a time
};

/// Adds what the user defined: columns of tables and metrics of a program.
void measure_users(const Measuring& how, const RunData& run, RunMetrics& result, std::vector<std::string>& remarks);

/// Reads and measures runs that may be pooled. Throws as pooled_runs and read_run do, std::invalid_argument for a run that is
/// shorter than `until_s`, and as measure_column and measure_own.
[[nodiscard]] RunSet read_set(std::span<const std::filesystem::path> paths, const Measuring& how = {});

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
                                            const Measuring& how = {});

}  // namespace trophic::analysis
