// SPDX-License-Identifier: MIT
// Definitions of files.hpp.
#include <tools/gait_evolution/files.hpp>

#include <tools/command/toml_writer.hpp>
#include <trophic/habitat/load/toml_table.hpp>
#include <trophic/io/csv.hpp>
#include <trophic/params/numbers_text.hpp>
#include <trophic/support/replace_file.hpp>
#include <trophic/support/version.hpp>

namespace trophic::gait_evolution {

namespace {

[[nodiscard]] NamedParams named_params_of(Params params, BackendChoice backend) {
  return trophic::named_params_of(param_refs_of(params, backend));
}

/// The parts of a pre-experiment in addition to its parameters: table, rules, engine, versions.
[[nodiscard]] NamedParams provenance(const PreExperiment& experiment) {
  const Params& params = experiment.params();
  const auto text = [](std::string_view value) { return std::string{value}; };
  NamedParams provenance{{"trophic", text(version), {}},
                         {"engine", experiment.backend().name() + " " + experiment.backend().version(), {}},
                         {"rule_table", text(enum_name(params.table)), {}},
                         {"parent_selection", text(enum_name(params.parent_selection.rule)), {}},
                         {"survivor_selection", text(enum_name(params.survivor_selection.rule)), {}},
                         {"fitness_rule", text(enum_name(params.fitness.rule)), {}},
                         {"steering_rule", text(control::steering::TargetedSteering::name), {}},
                         {"robot_fingerprint", hash_text(numbers_text(experiment.robot())), {}}};
  const std::vector<std::string> remarks = experiment.backend().remarks(params.physics);
  for (std::size_t i = 0; i < remarks.size(); ++i)
    provenance.push_back({"engine_remark_" + std::to_string(i + 1), remarks[i], {}});
  return provenance;
}

/// 16 hexadecimal digits of everything that determines a pre-experiment's results: all but the engine's threads.
[[nodiscard]] std::string fingerprint(const PreExperiment& experiment) {
  std::string text;
  for (const NamedParam& fact : provenance(experiment)) text += fact.path + "=" + value_text(fact) + "\n";
  for (const NamedParam& number : named_params_of(experiment.params(), experiment.backend())) {
    if (number.path != "backend.threads") text += number.path + "=" + value_text(number) + "\n";
  }
  return hash_text(text);
}

}  // namespace

std::string phylogeny_csv(const Lineage& lineage) {
  std::vector<TaxonRow> rows;
  for (const Individual& one : lineage.individuals) {
    std::string ancestors;
    for (const std::size_t parent : one.parents) ancestors += (ancestors.empty() ? "" : ",") + number_text(parent);
    rows.push_back({.id = rows.size(),
                    .ancestor_list = "[" + (ancestors.empty() ? std::string{"none"} : ancestors) + "]",
                    .origin_time = one.born,
                    .destruction_time = one.died,
                    .fitness = one.fitness,
                    .hidden_nodes = one.genome.nodes.size() - 1,
                    .enabled_links = static_cast<std::size_t>(std::ranges::count_if(one.genome.links, &LinkGene::enabled))});
  }
  return io::table_text(std::span<const TaxonRow>{rows});
}

std::string settings_text(Params params, BackendChoice backend) {
  TomlWriter writer;
  writer.put("rule_table", params.table);
  writer.put("fitness_rule", params.fitness.rule);
  writer.put("engine", backend.name());
  writer.put_all(named_params_of(std::move(params), std::move(backend)));
  return writer.text();
}

std::string champion_file(const PreExperiment& experiment) {
  const std::size_t id = experiment.lineage().champion();
  const Individual& champion = experiment.lineage().individuals[id];
  const Gait gait = champion.genome.network().gait_of(experiment.robot());
  TomlWriter writer;
  writer.put("name", experiment.robot().name);
  writer.put("robot", gait.robot);
  writer.put("provenance", "evolved for this robot by `trophic evolve-gait`; its numbers and CPPN are below");
  writer.put("hinges", gait.hinges);
  writer.put("internal", std::vector<double>(gait.internal.begin(), gait.internal.end()));
  for (std::size_t i = 0; i < gait.hinges.size(); ++i) {
    for (std::size_t j = i + 1; j < gait.hinges.size(); ++j) {
      const double weight = gait.coupling(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
      if (weight == 0.0) continue;
      writer.element("coupling");
      writer.put("from", gait.hinges[i]);
      writer.put("to", gait.hinges[j]);
      writer.put("weight", weight);
    }
  }
  writer.table("cppn");
  writer.put("nodes", champion.genome.nodes);
  writer.put("links", champion.genome.links);
  NamedParams about = provenance(experiment);
  about.push_back({"fitness", champion.fitness, "m"});
  about.push_back({"individual", static_cast<std::int64_t>(id), {}});
  about.push_back({"born_in_generation", static_cast<std::int64_t>(champion.born), {}});
  about.push_back({"generations_done", static_cast<std::int64_t>(experiment.lineage().generations) - 1, "after the founders"});
  about.push_back({"fingerprint", fingerprint(experiment), {}});
  writer.put_all(about, "evolution");
  NamedParams params = named_params_of(experiment.params(), experiment.backend());
  for (NamedParam& param : params) param.help.clear();
  writer.put_all(params, "evolution.params");
  return writer.text();
}

void save(const PreExperiment& experiment, const std::filesystem::path& folder) {
  const Lineage& lineage = experiment.lineage();
  std::vector<double> fitness;
  for (const Individual& individual : lineage.individuals) fitness.push_back(individual.fitness);
  TomlWriter checkpoint;
  checkpoint.put("fingerprint", fingerprint(experiment));
  checkpoint.put("fitness", fitness);
  replace_file(folder / "checkpoint.toml", checkpoint.text());
  if (fitness.empty()) return;
  replace_file(folder / "phylogeny.csv", phylogeny_csv(lineage));
  if (lineage.has_champion()) replace_file(folder / "gait.toml", champion_file(experiment));
}

void resume(PreExperiment& experiment, const std::filesystem::path& folder) {
  const auto file = trophic::detail::TomlTable::read(folder / "checkpoint.toml");
  if (const std::string found = file.text("fingerprint"), ours = fingerprint(experiment); found != ours) {
    file.fail("fingerprint",
              " = \"" + found + "\": must be \"" + ours + "\"; robot, parameters or engine differ from those of the checkpoint");
  }
  const std::vector<double> fitness = file.numbers("fitness");
  file.no_other_keys();
  const auto is_score = [](double score) { return score < std::numeric_limits<double>::infinity(); };  // no NaN either
  if (!std::ranges::all_of(fitness, is_score)) file.fail("fitness", ": each must be finite or -inf");
  try {
    experiment.replay(fitness);
  } catch (const std::invalid_argument& error) {
    file.fail("fitness", std::string{": "} + error.what());
  }
}

}  // namespace trophic::gait_evolution
