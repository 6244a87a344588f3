// SPDX-License-Identifier: MIT
// The runs of a sweep, compared with its plan before any is measured.
#pragma once

#include <filesystem>
#include <tools/analysis/data/sweep_grid.hpp>
#include <tools/sweep/plan_file.hpp>
#include <trophic/population/food_web.hpp>

namespace trophic::analysis {

/// A sweep on the disk. It keeps only the food webs of manifests: there may be tens of thousands.
struct SweepRuns {
  std::filesystem::path folder;
  std::vector<sweep::PlannedRun> plan;
  SweepGrid grid;
  std::vector<bool> is_there;        ///< of each planned run: complete, as planned
  std::vector<std::string> missing;  ///< a sentence for each that is not
  std::vector<FoodWeb> webs;         ///< those of the runs, each once
  std::vector<std::string> builds;   ///< the codes of the programs that made the runs, each once

  [[nodiscard]] std::filesystem::path folder_of(std::size_t run) const { return folder / plan[run].folder; }
};

/// Whether a folder is a sweep's.
[[nodiscard]] bool is_sweep(const std::filesystem::path& folder);

/// Reads a sweep's plan and holds every run's manifest against it. Throws std::invalid_argument for a broken plan, for a
/// fingerprint, seed or duration that is not the planned one, for a shadow that is none, for runs that several builds of a
/// program made unless `any_build`, and if no run is there. Runs that are missing or incomplete go to `missing`.
[[nodiscard]] SweepRuns read_sweep(const std::filesystem::path& folder, bool any_build = false);

/// The missing runs in one line; of many the first few.
[[nodiscard]] std::string missing_line(const SweepRuns& sweep);

}  // namespace trophic::analysis
