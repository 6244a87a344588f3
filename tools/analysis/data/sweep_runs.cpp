// SPDX-License-Identifier: MIT
// Definitions of sweep_runs.hpp.
#include <tools/analysis/data/sweep_runs.hpp>

#include <set>
#include <tools/reading/run_manifest.hpp>
#include <tools/reading/shadow.hpp>
#include <trophic/params/params.hpp>

namespace trophic::analysis {

bool is_sweep(const std::filesystem::path& folder) {
  return std::filesystem::exists(folder / sweep::plan_name);
}

namespace {

bool is_same_web(const FoodWeb& a, const FoodWeb& b) {
  if (a.size() != b.size()) return false;
  for (Species one = 0; one < a.size(); ++one) {
    if (a.name(one) != b.name(one)) return false;
    for (Species other = 0; other < a.size(); ++other) {
      if (a.eats(one, other) != b.eats(one, other)) return false;
    }
  }
  return true;
}

/// Why a planned run is not there; empty if it is. Throws std::invalid_argument if another run is in its place.
std::string why_missing(const std::filesystem::path& folder, const sweep::PlannedRun& planned,
                        std::optional<RunManifest>& manifest) {
  if (!std::filesystem::exists(folder)) return "no such folder";
  if (!std::filesystem::exists(folder / "manifest.json")) return "no manifest.json";
  try {
    manifest = read_manifest(folder);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  const auto check = [&](const std::string& field, const std::string& there, const std::string& wanted) {
    if (there == wanted) return;
    throw std::invalid_argument{(folder / "manifest.json").string() + ": " + field + " = " + there + ": must be " + wanted +
                                ", as the plan has it for run " + std::to_string(planned.index)};
  };
  check("fingerprint", manifest->fingerprint, planned.fingerprint);
  check("seed", std::to_string(manifest->seed), std::to_string(planned.seed));
  check("until_s", number_text(manifest->until_s), number_text(planned.until_s));
  if (manifest->status == "complete") return "";
  return "status \"" + manifest->status + "\", must be \"complete\"";
}

/// Compares the first shadow of each cell with its run.
void check_shadows(const SweepRuns& sweep) {
  for (const GridCell& cell : sweep.grid.cells) {
    const auto both = std::ranges::find_if(cell.replicates, [&](const GridReplicate& replicate) {
      return replicate.run && replicate.shadow && sweep.is_there[*replicate.run] && sweep.is_there[*replicate.shadow];
    });
    if (both == cell.replicates.end()) continue;
    check_shadow(read_manifest(sweep.folder_of(*both->run)), read_manifest(sweep.folder_of(*both->shadow)));
  }
}

}  // namespace

SweepRuns read_sweep(const std::filesystem::path& folder, bool any_build) {
  SweepRuns sweep{folder, sweep::read_plan(folder / sweep::plan_name), {}, {}, {}, {}, {}};
  std::set<std::string> builds;
  sweep.grid = grid_of(sweep.plan);
  for (const sweep::PlannedRun& planned : sweep.plan) {
    std::optional<RunManifest> manifest;
    const std::string why = why_missing(sweep.folder_of(planned.index), planned, manifest);
    sweep.is_there.push_back(why.empty());
    if (why.empty()) builds.insert(manifest->builds.begin(), manifest->builds.end());
    if (!why.empty()) {
      sweep.missing.push_back("run " + std::to_string(planned.index) + " (" + planned.folder.string() + "): " + why);
    } else if (!std::ranges::any_of(sweep.webs, [&](const FoodWeb& web) { return is_same_web(web, manifest->web); })) {
      sweep.webs.push_back(std::move(manifest->web));
    }
  }
  sweep.builds.assign(builds.begin(), builds.end());
  if (sweep.builds.size() > 1 && !any_build) {
    throw std::invalid_argument{folder.string() + ": its runs were made by " + builds_text(sweep.builds) +
                                "; builds of a program may have other rules under the same names: --accept-other-build pools "
                                "them"};
  }
  if (sweep.webs.empty()) throw std::invalid_argument{folder.string() + ": has no complete run; " + sweep.missing.front()};
  check_shadows(sweep);
  return sweep;
}

std::string missing_line(const SweepRuns& sweep) {
  constexpr std::size_t shown = 10;
  std::string line = std::to_string(sweep.missing.size()) + " of " + std::to_string(sweep.plan.size()) + " runs missing: ";
  for (std::size_t i = 0; i < std::min(shown, sweep.missing.size()); ++i) line += (i > 0 ? "; " : "") + sweep.missing[i];
  if (sweep.missing.size() > shown) line += "; and " + std::to_string(sweep.missing.size() - shown) + " more";
  return line;
}

}  // namespace trophic::analysis
