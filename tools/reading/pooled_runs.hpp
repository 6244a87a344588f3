// SPDX-License-Identifier: MIT
// Runs that belong together: one experiment, several seeds.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <tools/reading/run_manifest.hpp>
#include <vector>

namespace trophic::analysis {

/// Runs of one fingerprint.
struct PooledRuns {
  std::vector<RunManifest> manifests;  ///< at least one
  std::vector<std::string> remarks;
};

/// Why two runs are not pooled: a sentence that names both; empty if they may be. `any_build`: also runs that different builds of
/// a program made.
[[nodiscard]] std::string why_not_pooled(const RunManifest& manifest, const RunManifest& other, bool is_cut,
                                         bool any_build = false);

/// Finds the runs of some folders and sees that they may be pooled; `is_cut`: all will be cut to one duration. A run without a
/// folder is left out and remarked on, and so are several builds. Throws std::invalid_argument if runs differ in fingerprint,
/// build, beginning, status, duration or the ticks in agents.csv, if one is there twice, if a manifest cannot be read, or if
/// there is no run.
[[nodiscard]] PooledRuns pooled_runs(std::span<const std::filesystem::path> paths, bool is_cut, bool any_build = false);

/// Whether a folder is a sweep's.
[[nodiscard]] inline bool is_sweep(const std::filesystem::path& folder) {
  return std::filesystem::exists(folder / "plan.jsonl");
}

}  // namespace trophic::analysis
