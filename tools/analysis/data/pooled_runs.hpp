// SPDX-License-Identifier: MIT
// Which runs belong together: one experiment, several seeds.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <tools/analysis/data/run_manifest.hpp>
#include <vector>

namespace trophic::analysis {

/// Runs of one fingerprint.
struct PooledRuns {
  std::vector<RunManifest> manifests;  ///< at least one
  std::vector<std::string> remarks;
};

/// The folders of the runs that a path stands for: the path itself, or the replicates that its replicates.json lists. A listed
/// one that is not there goes to `remarks`. Throws std::invalid_argument for a path that is no folder or a broken list.
[[nodiscard]] std::vector<std::filesystem::path> run_folders(const std::filesystem::path& path,
                                                             std::vector<std::string>& remarks);

/// Why two runs are not pooled: a sentence that names both; empty where they may be.
[[nodiscard]] std::string why_not_pooled(const RunManifest& manifest, const RunManifest& other, bool is_cut);

/// Finds the runs of some folders and sees that they may be pooled; `is_cut`: all will be cut to one duration. A run without a
/// readable manifest is left out and remarked on. Throws std::invalid_argument if runs differ in fingerprint, beginning, status,
/// duration or the ticks in agents.csv, if one is there twice, or if nothing can be read.
[[nodiscard]] PooledRuns pooled_runs(std::span<const std::filesystem::path> paths, bool is_cut);

}  // namespace trophic::analysis
