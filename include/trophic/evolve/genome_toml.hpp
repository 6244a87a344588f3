// SPDX-License-Identifier: MIT
// A CPPN genome as TOML, exact to the bit.
#pragma once

#include <toml++/toml.h>

#include <concepts>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <trophic/evolve/genome.hpp>
#include <type_traits>

namespace trophic::evolve {

/// `nodes = [{id, activation}, ...]`, `links = [{innovation, from, to, weight, enabled}, ...]`.
[[nodiscard]] inline toml::table genome_to_toml(const Genome& genome) {
  toml::array nodes;
  for (const NodeGene& node : genome.nodes) {
    nodes.push_back(toml::table{{"id", node.id}, {"activation", enum_name(node.activation)}});
  }
  toml::array links;
  for (const LinkGene& link : genome.links) {
    links.push_back(toml::table{{"innovation", link.innovation},
                                {"from", link.from},
                                {"to", link.to},
                                {"weight", link.weight},
                                {"enabled", link.enabled}});
  }
  return toml::table{{"nodes", std::move(nodes)}, {"links", std::move(links)}};
}

namespace detail {

/// One value of a gene. Throws std::runtime_error "SOURCE: cppn.GENE.KEY: ...".
template <class T>
T gene_value(const toml::table& gene, std::string_view key, const std::string& place) {
  const std::string name = place + "." + std::string{key};
  const toml::node_view<const toml::node> value = gene[key];
  if (!value) throw std::runtime_error{name + " is missing"};
  if constexpr (std::same_as<T, std::uint32_t>) {
    if (const auto number = value.value_exact<std::int64_t>()) {
      if (*number >= 0 && *number <= std::numeric_limits<T>::max()) return static_cast<T>(*number);
    }
    throw std::runtime_error{name + ": must be an integer >= 0 and < 2^32"};
  } else if constexpr (std::same_as<T, Activation>) {
    for (const Activation activation : all_activations) {
      if (value.value<std::string_view>() == enum_name(activation)) return activation;
    }
    throw std::runtime_error{name + ": must be sine, gaussian, tanh, step, linear or abs"};
  } else {
    if (const auto read = value.value<T>()) return *read;
    throw std::runtime_error{name + (std::same_as<T, bool> ? ": must be true or false" : ": must be a number")};
  }
}

template <class Read>
void for_each_gene(const toml::table& genome, std::string_view key, const std::string& source, Read&& read) {
  const toml::array* genes = genome[key].as_array();
  const std::string name = source + ": cppn." + std::string{key};
  if (genes == nullptr) throw std::runtime_error{name + ": must be an array of tables"};
  for (std::size_t i = 0; i < genes->size(); ++i) {
    const toml::table* gene = (*genes)[i].as_table();
    const std::string place = name + "[" + std::to_string(i) + "]";
    if (gene == nullptr) throw std::runtime_error{place + ": must be a table"};
    read(*gene, place);
  }
}

}  // namespace detail

/// The inverse of `genome_to_toml`. Throws std::runtime_error naming `source`, gene, key and rule, for a genome that is not
/// valid too.
[[nodiscard]] inline Genome genome_from_toml(const toml::table& table, const std::string& source) {
  Genome genome;
  detail::for_each_gene(table, "nodes", source, [&](const toml::table& gene, const std::string& place) {
    genome.nodes.push_back({.id = detail::gene_value<std::uint32_t>(gene, "id", place),
                            .activation = detail::gene_value<Activation>(gene, "activation", place)});
  });
  detail::for_each_gene(table, "links", source, [&](const toml::table& gene, const std::string& place) {
    genome.links.push_back({.innovation = detail::gene_value<std::uint32_t>(gene, "innovation", place),
                            .from = detail::gene_value<std::uint32_t>(gene, "from", place),
                            .to = detail::gene_value<std::uint32_t>(gene, "to", place),
                            .weight = detail::gene_value<double>(gene, "weight", place),
                            .enabled = detail::gene_value<bool>(gene, "enabled", place)});
  });
  try {
    validate(genome);
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error{source + ": " + error.what()};
  }
  return genome;
}

}  // namespace trophic::evolve
