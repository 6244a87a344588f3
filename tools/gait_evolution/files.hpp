// SPDX-License-Identifier: MIT
// The files of a pre-experiment, and how to resume from them.
#pragma once

#include <filesystem>
#include <tools/gait_evolution/pre_experiment.hpp>
#include <trophic/io/column.hpp>

namespace trophic::gait_evolution {

/// phylogeny.csv: one row a candidate, in the ALife data standard, time in generations.
struct TaxonRow {
  std::size_t id = 0;
  std::string ancestor_list = {};
  std::size_t origin_time = 0;
  std::optional<std::size_t> destruction_time = {};
  double fitness = 0.0;
  std::size_t hidden_nodes = 0;
  std::size_t enabled_links = 0;

  static constexpr auto columns() {
    using io::column;
    return std::tuple{
        column("id", &TaxonRow::id, "", "the candidate"),
        column("ancestor_list", &TaxonRow::ancestor_list, "", "parents: [none], [3] or, after a crossover, [3,9]"),
        column("origin_time", &TaxonRow::origin_time, "generations", "generation of birth"),
        column("destruction_time", &TaxonRow::destruction_time, "generations",
               "generation in which the candidate was not selected; inf if it is alive at the end", {.none = "inf"}),
        column("fitness", &TaxonRow::fitness, "m", "fitness; -inf if the trial diverged"),
        column("hidden_nodes", &TaxonRow::hidden_nodes, "", "number of hidden nodes in its CPPN"),
        column("enabled_links", &TaxonRow::enabled_links, "", "number of enabled links in its CPPN")};
  }
};

[[nodiscard]] std::string phylogeny_csv(const Lineage& lineage);

/// The parameters as TOML, as --config reads them.
[[nodiscard]] std::string settings_text(Params params, BackendChoice backend);

/// The champion's gait file (format: models/README.md), exact to the bit, with the tables [cppn], its genome, and [evolution],
/// everything that made it. At least the founders must have been tried out.
[[nodiscard]] std::string champion_file(const PreExperiment& experiment);

/// Writes checkpoint.toml and, once there are candidates, phylogeny.csv; gait.toml (the champion so far) once there is one. Each
/// file is replaced as a whole. Nothing in them depends on the number of threads or on how often the run was resumed.
void save(const PreExperiment& experiment, const std::filesystem::path& folder);

/// Resumes from the checkpoint in a folder. Throws std::invalid_argument naming file, key and value for one that cannot be read,
/// is broken or belongs to another pre-experiment.
void resume(PreExperiment& experiment, const std::filesystem::path& folder);

}  // namespace trophic::gait_evolution
