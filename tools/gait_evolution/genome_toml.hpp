// SPDX-License-Identifier: MIT
// A CPPN genome as TOML, exact to the bit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tools/gait_evolution/genome.hpp>
#include <trophic/habitat/load/toml_table.hpp>
#include <trophic/habitat/load/toml_writer.hpp>
#include <trophic/params/params.hpp>

namespace trophic::gait_evolution {

/// `nodes = [{id, activation}, ...]` and `links = [{innovation, from, to, weight, enabled}, ...]`, into the table at hand.
inline void put_genome(TomlWriter& writer, const Genome& genome) {
  writer.put("nodes", genome.nodes);
  writer.put("links", genome.links);
}

namespace detail {

using trophic::detail::TomlTable;

inline std::uint32_t gene_number(const TomlTable& gene, std::string_view key) {
  const std::size_t number = gene.whole_number(key, 0);
  if (number > std::numeric_limits<std::uint32_t>::max()) gene.fail(key, " = " + number_text(number) + ": must be < 2^32");
  return static_cast<std::uint32_t>(number);
}

inline Activation activation(const TomlTable& gene) {
  const std::string name = gene.text("activation");
  for (const Activation activation : all_activations) {
    if (name == enum_name(activation)) return activation;
  }
  gene.fail("activation", " = \"" + name + "\": must be sine, gaussian, tanh, step, linear or abs");
}

}  // namespace detail

/// The genome of a table that `put_genome` wrote; other keys of the table are left to the caller. Throws std::invalid_argument
/// "FILE: KEY = VALUE: must be ...", for a genome that is not valid too.
[[nodiscard]] inline Genome read_genome(const trophic::detail::TomlTable& table) {
  Genome genome;
  for (const auto& gene : table.tables("nodes")) {
    genome.nodes.push_back({.id = detail::gene_number(gene, "id"), .activation = detail::activation(gene)});
    gene.no_other_keys();
  }
  for (const auto& gene : table.tables("links")) {
    genome.links.push_back({.innovation = detail::gene_number(gene, "innovation"),
                            .from = detail::gene_number(gene, "from"),
                            .to = detail::gene_number(gene, "to"),
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
