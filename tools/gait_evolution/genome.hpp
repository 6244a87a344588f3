// SPDX-License-Identifier: MIT
// The genome of a CPPN: node and link genes with innovation numbers, and what makes one valid.
#pragma once

#include <algorithm>
#include <set>
#include <tools/gait_evolution/activation.hpp>
#include <trophic/params/params.hpp>
#include <vector>

namespace trophic::gait_evolution {

/// A node that computes. Equal ids in two genomes stem from the same innovation; the activation is the genome's own.
struct NodeGene {
  std::uint32_t id = 0;
  Activation activation = Activation::sine;
  friend bool operator==(const NodeGene&, const NodeGene&) = default;

  static constexpr auto fields() {
    return std::tuple{field("id", &NodeGene::id, "unique in a genome"), field("activation", &NodeGene::activation)};
  }
};

/// A weighted link between two nodes. Equal innovation numbers mean equal ends in all genomes of a run.
struct LinkGene {
  std::uint32_t innovation = 0;
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  double weight = 0.0;
  bool enabled = true;
  friend bool operator==(const LinkGene&, const LinkGene&) = default;

  static constexpr auto fields() {
    return std::tuple{field("innovation", &LinkGene::innovation), field("from", &LinkGene::from), field("to", &LinkGene::to),
                      field("weight", &LinkGene::weight), field("enabled", &LinkGene::enabled)};
  }
};

/// A compositional pattern producing network [stanley2007] (Sec. "Targeted Steering": CPPNs), whose genes are those
/// of networks that grow [stanley2002]. Seven inputs, nodes 0 to 6: the constant 1, then x, y, z of two
/// modules' grid cells; one output, node 7; hidden nodes from 8 on. Invariants: see `validate`.
struct Genome {
  static constexpr std::uint32_t inputs = 7;
  static constexpr std::uint32_t output = inputs;

  std::vector<NodeGene> nodes;  ///< output and hidden, ids ascending
  std::vector<LinkGene> links;  ///< innovation numbers ascending

  friend bool operator==(const Genome&, const Genome&) = default;

  [[nodiscard]] bool has_node(std::uint32_t id) const;
  /// The link between two nodes, disabled ones included, or links.end().
  [[nodiscard]] auto find_link(std::uint32_t from, std::uint32_t to) const {
    return std::ranges::find_if(links, [=](const LinkGene& link) { return link.from == from && link.to == to; });
  }
};

/// The nodes in an order in which every link, disabled ones included, leads from an earlier node (or an input) to a later one;
/// of the nodes that could come next the smallest id comes first. Shorter than genome.nodes where links form a cycle.
[[nodiscard]] std::vector<NodeGene> topological_order(const Genome& genome);

/// A node and all that its links, disabled ones included, lead to.
[[nodiscard]] std::set<std::uint32_t> reachable_from(const Genome& genome, std::uint32_t node);

/// Throws std::invalid_argument naming gene, value and rule unless: node ids ascend from the output's; innovation numbers
/// ascend; every link joins two existing nodes, leads into no input and out of no output; no two links join the same nodes;
/// weights are finite; no cycle, disabled links included.
void validate(const Genome& genome);

}  // namespace trophic::gait_evolution
