// SPDX-License-Identifier: MIT
// Definitions of gait_file.hpp.
#include <tools/gait_evolution/gait_file.hpp>

#include <tools/gait_evolution/genome_toml.hpp>
#include <trophic/habitat/load/models.hpp>
#include <trophic/habitat/load/toml_table.hpp>
#include <trophic/habitat/load/toml_writer.hpp>

namespace trophic::gait_evolution {

std::string gait_file(const Gait& gait, const Genome& genome, const NamedParams& provenance, const NamedParams& parameters) {
  TomlWriter writer;
  put_gait(writer, gait);
  writer.table("cppn");
  put_genome(writer, genome);
  writer.put_all(provenance, "evolution");
  NamedParams plain = parameters;
  for (NamedParam& param : plain) param.help.clear();
  writer.put_all(plain, "evolution.params");
  return writer.text();
}

Genome load_cppn(std::string_view name_or_path) {
  const auto file = trophic::detail::TomlTable::read(find_model(ModelKind::gait, name_or_path));
  const auto cppn = file.table("cppn");
  Genome genome = read_genome(cppn);
  cppn.no_other_keys();
  return genome;
}

}  // namespace trophic::gait_evolution
