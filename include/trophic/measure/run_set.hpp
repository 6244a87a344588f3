// SPDX-License-Identifier: MIT
// Runs that belong together: one experiment, several seeds.
#pragma once

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <span>
#include <stdexcept>
#include <string>
#include <trophic/measure/read_run.hpp>
#include <trophic/measure/run_metrics.hpp>
#include <utility>
#include <vector>

namespace trophic::measure {

/// Runs of one fingerprint with what was measured in each.
struct RunSet {
  std::string label;             ///< name of the rule table
  std::vector<RunFacts> facts;   ///< one per run
  std::vector<RunMetrics> runs;  ///< in the order of `facts`
  std::vector<std::string> remarks;
};

/// The folders of the runs that a path stands for: the path itself, or the replicates that its replicates.json lists. A listed
/// one that is not there goes to `remarks`. Throws std::runtime_error for a path that is no folder or a broken list.
[[nodiscard]] inline std::vector<std::filesystem::path> run_folders(const std::filesystem::path& path,
                                                                    std::vector<std::string>& remarks) {
  if (!std::filesystem::is_directory(path)) throw std::runtime_error{path.string() + ": is not a folder"};
  const std::filesystem::path list = path / "replicates.json";
  if (!std::filesystem::exists(list)) return {path};
  std::ifstream file{list};
  std::vector<std::filesystem::path> folders;
  try {
    const auto json = nlohmann::json::parse(file);
    for (const auto& replicate : json.at("replicates")) {
      const std::filesystem::path folder = path / replicate.at("folder").get<std::string>();
      if (std::filesystem::is_directory(folder)) {
        folders.push_back(folder);
      } else {
        remarks.push_back(folder.string() + ": missing, the replicate was not run");
      }
    }
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error{list.string() + ": " + error.what()};
  }
  return folders;
}

/// Reads and measures runs that may be pooled. A run without a readable manifest is left out and remarked on. Throws
/// std::invalid_argument if fingerprints differ or a run is there twice, std::runtime_error if nothing can be read.
[[nodiscard]] inline RunSet read_set(std::span<const std::filesystem::path> paths) {
  RunSet set;
  std::vector<std::filesystem::path> folders;
  for (const std::filesystem::path& path : paths) {
    for (auto& folder : run_folders(path, set.remarks)) folders.push_back(std::move(folder));
  }
  for (const std::filesystem::path& folder : folders) {
    RunFacts facts;
    try {
      facts = read_facts(folder);
    } catch (const std::runtime_error& error) {
      set.remarks.push_back(std::string{error.what()} + "; left out");
      continue;
    }
    for (const RunFacts& other : set.facts) {
      if (other.fingerprint != facts.fingerprint) {
        throw std::invalid_argument{folder.string() + ": fingerprint " + facts.fingerprint + " (" + facts.rules + " on " +
                                    facts.backend + "), but " + other.folder.string() + " has " + other.fingerprint + " (" +
                                    other.rules + " on " + other.backend +
                                    "); runs of different rules or numbers are not pooled: use --compare"};
      }
      if (other.seed == facts.seed) {
        throw std::invalid_argument{folder.string() + ": seed " + std::to_string(facts.seed) + " as in " + other.folder.string() +
                                    "; the same run twice is no second replicate"};
      }
    }
    set.facts.push_back(std::move(facts));
  }
  if (set.facts.empty()) {
    const std::string why = set.remarks.empty() ? "" : ": " + set.remarks.front();
    throw std::runtime_error{"no run can be read" + why};
  }
  set.label = set.facts.front().rules;
  for (const RunFacts& facts : set.facts) {
    const RunData run = read_run(facts.folder);
    set.remarks.insert(set.remarks.end(), run.remarks.begin(), run.remarks.end());
    set.runs.push_back(measure_run(run));
  }
  return set;
}

}  // namespace trophic::measure
