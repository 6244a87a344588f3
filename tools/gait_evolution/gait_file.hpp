// SPDX-License-Identifier: MIT
// A gait file that tells what its gait was evolved from and how.
#pragma once

#include <string>
#include <string_view>
#include <tools/gait_evolution/genome.hpp>
#include <tools/gait_evolution/genome_toml.hpp>
#include <trophic/habitat/load/gait.hpp>
#include <trophic/habitat/load/models.hpp>
#include <trophic/habitat/load/toml_table.hpp>
#include <trophic/habitat/load/toml_writer.hpp>
#include <trophic/params/named_params.hpp>

namespace trophic::gait_evolution {

/// The text of a gait file (format: models/README.md) with the tables [cppn], the genome, and [evolution], the provenance with
/// all numbers below it. `load_gait` reads the gait, `load_cppn` the genome.
[[nodiscard]] inline std::string gait_file(const Gait& gait, const Genome& genome, const NamedParams& provenance,
                                           const NamedParams& numbers) {
  TomlWriter writer;
  put_gait(writer, gait);
  writer.table("cppn");
  put_genome(writer, genome);
  writer.put_all(provenance, "evolution");
  NamedParams plain = numbers;
  for (NamedParam& param : plain) param.help.clear();
  writer.put_all(plain, "evolution.params");
  return writer.text();
}

/// The genome in a gait file, by name or path. Errors as `load_gait`.
[[nodiscard]] inline Genome load_cppn(std::string_view name_or_path) {
  const auto file = trophic::detail::TomlTable::read(find_model(ModelKind::gait, name_or_path));
  const auto cppn = file.table("cppn");
  Genome genome = read_genome(cppn);
  cppn.no_other_keys();
  return genome;
}

}  // namespace trophic::gait_evolution
