// SPDX-License-Identifier: MIT
// The files of a pre-experiment, and how to resume from them.
#pragma once

#include <cmath>
#include <filesystem>
#include <tools/gait_evolution/checkpoint.hpp>
#include <tools/gait_evolution/cppn_gait.hpp>
#include <tools/gait_evolution/gait_file.hpp>
#include <tools/gait_evolution/history.hpp>
#include <tools/gait_evolution/pre_experiment.hpp>
#include <tools/gait_evolution/tables.hpp>
#include <trophic/habitat/load/toml_table.hpp>
#include <trophic/habitat/robot_model.hpp>
#include <trophic/params/named_params.hpp>
#include <trophic/params/numbers_text.hpp>
#include <trophic/support/replace_file.hpp>
#include <trophic/support/version.hpp>

namespace trophic::gait_evolution {

/// The parts of a pre-experiment in addition to its parameters: table, policies, seed, engine, versions.
template <class Table>
[[nodiscard]] NamedParams provenance(const PreExperiment<Table>& experiment) {
  const auto text = [](std::string_view value) { return std::string{value}; };
  NamedParams provenance{{"trophic", text(version), {}},
                         {"engine", experiment.backend().name() + " " + experiment.backend().version(), {}},
                         {"rule_table", text(Table::name), {}},
                         {"parent_selection", text(Table::ParentSelection::name), {}},
                         {"survivor_selection", text(Table::SurvivorSelection::name), {}},
                         {"fitness_rule", text(Table::Fitness::name), {}},
                         {"steering_rule", text(Table::Steering::name), {}},
                         {"robot_fingerprint", hash_text(numbers_text(experiment.robot())), {}}};
  const std::vector<std::string> remarks = experiment.backend().remarks(experiment.params().physics);
  for (std::size_t i = 0; i < remarks.size(); ++i)
    provenance.push_back({"engine_remark_" + std::to_string(i + 1), remarks[i], {}});
  return provenance;
}

/// 16 hexadecimal digits of everything that determines a pre-experiment's results: provenance, robot and parameters but the
/// engine's threads.
template <class Table>
[[nodiscard]] std::string fingerprint(const PreExperiment<Table>& experiment) {
  std::string text;
  for (const NamedParam& fact : provenance(experiment)) text += fact.path + "=" + value_text(fact) + "\n";
  for (const NamedParam& number : experiment.named_params()) {
    if (number.path != "backend.threads") text += number.path + "=" + value_text(number) + "\n";
  }
  return hash_text(text);
}

/// The champion's gait file, with everything that made it. At least the founders must have been tried out.
template <class Table>
[[nodiscard]] std::string champion_file(const PreExperiment<Table>& experiment) {
  const std::size_t id = experiment.lineage().champion();
  const Individual& champion = experiment.lineage().individuals[id];
  Gait gait = cppn_gait(champion.genome, experiment.robot());
  gait.name = experiment.robot().name;
  gait.provenance = "evolved for this robot by `trophic evolve-gait`; its numbers and CPPN are below";
  NamedParams about = provenance(experiment);
  about.push_back({"fitness", champion.fitness, "m"});
  about.push_back({"individual", static_cast<std::int64_t>(id), {}});
  about.push_back({"born_in_generation", static_cast<std::int64_t>(champion.born), {}});
  about.push_back({"generations_done", static_cast<std::int64_t>(experiment.lineage().generations) - 1, "after the founders"});
  about.push_back({"fingerprint", fingerprint(experiment), {}});
  return gait_file(gait, champion.genome, about, experiment.named_params());
}

/// Whether a candidate has walked: the trials of all others diverged.
template <class Table>
[[nodiscard]] bool has_champion(const PreExperiment<Table>& experiment) {
  const Lineage& lineage = experiment.lineage();
  return !lineage.individuals.empty() && std::isfinite(lineage.individuals[lineage.champion()].fitness);
}

/// Writes checkpoint.toml and, once there are candidates, generations.csv and phylogeny.csv; gait.toml (the champion so far) once
/// there is one. Each file is replaced as a whole. Nothing in them depends on the number of threads or on how often the run was
/// resumed.
template <class Table>
void save(const PreExperiment<Table>& experiment, const std::filesystem::path& folder) {
  const Lineage& lineage = experiment.lineage();
  replace_file(folder / "checkpoint.toml", to_toml(lineage, fingerprint(experiment)));
  if (lineage.individuals.empty()) return;
  replace_file(folder / "generations.csv", generations_csv(lineage));
  replace_file(folder / "phylogeny.csv", phylogeny_csv(lineage));
  if (has_champion(experiment)) replace_file(folder / "gait.toml", champion_file(experiment));
}

/// Resumes from the checkpoint in a folder. Throws std::runtime_error for a file that is missing or broken and
/// std::invalid_argument for the checkpoint of another pre-experiment.
template <class Table>
void resume(PreExperiment<Table>& experiment, const std::filesystem::path& folder) {
  experiment.restore(read_lineage(trophic::detail::TomlTable::read(folder / "checkpoint.toml"), fingerprint(experiment)));
}

}  // namespace trophic::gait_evolution
