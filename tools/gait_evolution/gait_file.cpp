// SPDX-License-Identifier: MIT
// Definitions of gait_file.hpp.
#include <tools/gait_evolution/gait_file.hpp>

#include <tools/gait_evolution/genome_toml.hpp>
#include <trophic/habitat/load/models.hpp>
#include <trophic/habitat/load/toml_table.hpp>

namespace trophic::gait_evolution {

void put_gait(TomlWriter& writer, const Gait& gait) {
  validate(gait);
  writer.put("name", gait.name);
  writer.put("robot", gait.robot);
  writer.put("provenance", gait.provenance);
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
}

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
