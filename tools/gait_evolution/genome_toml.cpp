// SPDX-License-Identifier: MIT
// Definitions of genome_toml.hpp.
#include <tools/gait_evolution/genome_toml.hpp>

#include <cstddef>
#include <stdexcept>
#include <trophic/params/params.hpp>

namespace trophic::gait_evolution {

void put_genome(TomlWriter& writer, const Genome& genome) {
  writer.put("nodes", genome.nodes);
  writer.put("links", genome.links);
}

namespace {

using trophic::detail::TomlTable;

std::uint32_t gene_number(const TomlTable& gene, std::string_view key) {
  const std::size_t number = gene.whole_number(key, 0);
  if (number > std::numeric_limits<std::uint32_t>::max()) gene.fail(key, " = " + number_text(number) + ": must be < 2^32");
  return static_cast<std::uint32_t>(number);
}

Activation activation(const TomlTable& gene) {
  const std::string name = gene.text("activation");
  for (const Activation activation : all_activations) {
    if (name == enum_name(activation)) return activation;
  }
  gene.fail("activation", " = \"" + name + "\": must be sine, gaussian, tanh, step, linear or abs");
}

}  // namespace

Genome read_genome(const trophic::detail::TomlTable& table) {
  Genome genome;
  for (const auto& gene : table.tables("nodes")) {
    genome.nodes.push_back({.id = gene_number(gene, "id"), .activation = activation(gene)});
    gene.no_other_keys();
  }
  for (const auto& gene : table.tables("links")) {
    genome.links.push_back({.innovation = gene_number(gene, "innovation"),
                            .from = gene_number(gene, "from"),
                            .to = gene_number(gene, "to"),
                            .weight = gene.number("weight", any_number()),
                            .enabled = gene.truth("enabled")});
    gene.no_other_keys();
  }
  try {
    validate(genome);
  } catch (const std::invalid_argument& error) {
    table.fail("links", std::string{": "} + error.what());
  }
  return genome;
}

}  // namespace trophic::gait_evolution
