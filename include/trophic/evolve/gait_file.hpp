// SPDX-License-Identifier: MIT
// A gait file that tells what its gait was evolved from and how.
#pragma once

#include <string>
#include <string_view>
#include <trophic/config.hpp>
#include <trophic/control/gait.hpp>
#include <trophic/detail/toml_table.hpp>
#include <trophic/evolve/genome.hpp>
#include <trophic/evolve/genome_toml.hpp>
#include <trophic/models.hpp>
#include <trophic/settings.hpp>

namespace trophic::evolve {

/// The text of a gait file (format: models/README.md) with the tables [cppn], the genome, and [evolution], the facts with all
/// numbers below it. `control::load_gait` reads the gait, `load_cppn` the genome.
[[nodiscard]] inline std::string gait_file(const control::Gait& gait, const Genome& genome, const Settings& facts,
                                           const Settings& numbers) {
  Settings evolution;
  for (Setting setting : facts) {
    setting.path = "evolution." + setting.path;
    evolution.push_back(setting);
  }
  for (Setting setting : numbers) {
    setting.path = "evolution.numbers." + setting.path;
    setting.help.clear();
    evolution.push_back(setting);
  }
  return control::to_toml(gait) + "\n[cppn]\n" + to_toml(genome) + toml_text(evolution);
}

/// The genome in a gait file, by name or path. Errors as `control::load_gait`.
[[nodiscard]] inline Genome load_cppn(std::string_view name_or_path) {
  const auto file = trophic::detail::TomlTable::read(find_model(ModelKind::gait, name_or_path));
  const auto cppn = file.table("cppn");
  Genome genome = read_genome(cppn);
  cppn.no_other_keys();
  return genome;
}

}  // namespace trophic::evolve
