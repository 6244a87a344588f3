// SPDX-License-Identifier: MIT
// Definitions of pooled_runs.hpp.
#include <tools/reading/pooled_runs.hpp>

#include <set>
#include <tools/reading/run_folders.hpp>

namespace trophic::analysis {

std::string why_not_pooled(const RunManifest& manifest, const RunManifest& other, bool is_cut, bool any_build) {
  const std::string here = manifest.folder.string() + ": ";
  const std::string there = other.folder.string();
  if (manifest.fingerprint != other.fingerprint) {
    return here + "fingerprint " + manifest.fingerprint + " (" + manifest.rules + " on " + manifest.backend + "), but " + there +
           " has " + other.fingerprint + " (" + other.rules + " on " + other.backend +
           "); runs of different rules or parameters are not pooled: use --compare";
  }
  if (manifest.builds != other.builds && !any_build) {
    return here + "made by " + builds_text(manifest.builds) + ", but " + there + " by " + builds_text(other.builds) +
           "; builds of a program may have other rules under the same names: --accept-other-build pools them";
  }
  if (other.seed == manifest.seed) {
    return here + "seed " + std::to_string(manifest.seed) + " as in " + there + "; the same run twice is not a second replicate";
  }
  if (other.begins != manifest.begins) {
    const auto beginning = [](const RunManifest& run) {
      return "begins " + (run.begins.empty() ? "at its beginning" : run.begins);
    };
    return here + beginning(manifest) + ", but " + there + " " + beginning(other) +
           "; futures of one moment are not pooled with other runs";
  }
  if (other.changes != manifest.changes) {
    return here + std::to_string(manifest.changes.first) + " changes of parameters (changes.csv), but " + there + " has " +
           std::to_string(other.changes.first) + ", or others; runs with different changes are not pooled";
  }
  if (other.agents_every_ticks != manifest.agents_every_ticks) {
    return here + "agents_every_ticks " + std::to_string(manifest.agents_every_ticks) + ", but " + there + " has " +
           std::to_string(other.agents_every_ticks) + "; runs that say more and less of their robots are not pooled";
  }
  if (is_cut) return "";
  if (manifest.status != other.status || !lasted_alike(manifest, other)) {
    return here + lasted_text(manifest) + ", but " + there + " has " + lasted_text(other) +
           "; runs of different length are not pooled: leave some out, or cut all with --until";
  }
  return "";
}

PooledRuns pooled_runs(std::span<const std::filesystem::path> paths, bool is_cut, bool any_build) {
  PooledRuns pooled;
  std::vector<std::filesystem::path> folders;
  for (const std::filesystem::path& path : paths)
    for (auto& folder : run_folders(path, pooled.remarks)) folders.push_back(std::move(folder));
  for (const std::filesystem::path& folder : folders) {
    RunManifest manifest;
    try {
      manifest = read_manifest(folder);
    } catch (const std::runtime_error& error) {
      throw std::invalid_argument{error.what()};
    }
    for (const RunManifest& other : pooled.manifests) {
      if (const std::string why = why_not_pooled(manifest, other, is_cut, any_build); !why.empty())
        throw std::invalid_argument{why};
    }
    pooled.manifests.push_back(std::move(manifest));
  }
  if (pooled.manifests.empty()) {
    throw std::invalid_argument{"no run is there" + (pooled.remarks.empty() ? "" : ": " + pooled.remarks.front())};
  }
  std::set<std::string> builds;
  for (const RunManifest& manifest : pooled.manifests) builds.insert(manifest.builds.begin(), manifest.builds.end());
  if (builds.size() > 1) {
    pooled.remarks.push_back(std::to_string(builds.size()) +
                             " builds of a program made these runs: " + builds_text({builds.begin(), builds.end()}) +
                             "; their rules may be other code under the same names");
  }
  if (const std::string& begins = pooled.manifests.front().begins; pooled.manifests.size() > 1 && !begins.empty()) {
    pooled.remarks.push_back("all runs begin " + begins +
                             ": they share that past, so that intervals are over its futures, not over runs");
  }
  return pooled;
}

}  // namespace trophic::analysis
