// SPDX-License-Identifier: MIT
// Runs that belong together: one experiment, several seeds.
#pragma once

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <trophic/analysis/data/read_run.hpp>
#include <trophic/analysis/metrics/run_metrics.hpp>
#include <trophic/params/params.hpp>
#include <utility>
#include <vector>

namespace trophic::analysis {

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

/// Why two runs are not pooled: a sentence that names both; empty where they may be.
[[nodiscard]] inline std::string why_not_pooled(const RunFacts& facts, const RunFacts& other, bool is_cut) {
  const std::string here = facts.folder.string() + ": ";
  const std::string there = other.folder.string();
  if (facts.fingerprint != other.fingerprint) {
    return here + "fingerprint " + facts.fingerprint + " (" + facts.rules + " on " + facts.backend + "), but " + there + " has " +
           other.fingerprint + " (" + other.rules + " on " + other.backend +
           "); runs of different rules or numbers are not pooled: use --compare";
  }
  if (other.seed == facts.seed) {
    return here + "seed " + std::to_string(facts.seed) + " as in " + there + "; the same run twice is no second replicate";
  }
  if (is_cut) return "";
  const auto lasted = [](const RunFacts& run) {
    return "status \"" + run.status + "\" at " + (run.reached_s ? number_text(*run.reached_s) : "an unknown time") + " of " +
           number_text(run.until_s) + " s";
  };
  if (facts.status != other.status || facts.until_s != other.until_s || facts.reached_s != other.reached_s) {
    return here + lasted(facts) + ", but " + there + " has " + lasted(other) +
           "; runs of different length are not pooled: leave some out, or cut all with --until";
  }
  return "";
}

/// Reads and measures runs that may be pooled; with `until_s`, only their first seconds. A run without a readable manifest is
/// left out and remarked on. Throws std::invalid_argument if runs differ in fingerprint, status or duration, if one is there
/// twice or is shorter than `until_s`; std::runtime_error if nothing can be read.
[[nodiscard]] inline RunSet read_set(std::span<const std::filesystem::path> paths, std::optional<double> until_s = {}) {
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
      if (const std::string why = why_not_pooled(facts, other, until_s.has_value()); !why.empty()) {
        throw std::invalid_argument{why};
      }
    }
    set.facts.push_back(std::move(facts));
  }
  if (set.facts.empty()) {
    const std::string why = set.remarks.empty() ? "" : ": " + set.remarks.front();
    throw std::runtime_error{"no run can be read" + why};
  }
  set.label = set.facts.front().rules;
  for (RunFacts& facts : set.facts) {
    RunData run = read_run(facts.folder);
    if (until_s) cut_to(run, *until_s);
    facts.until_s = run.facts.until_s;
    set.remarks.insert(set.remarks.end(), run.remarks.begin(), run.remarks.end());
    set.runs.push_back(measure_run(run));
  }
  return set;
}

}  // namespace trophic::analysis
