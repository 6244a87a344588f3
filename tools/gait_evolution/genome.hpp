// SPDX-License-Identifier: MIT
// The genome of a CPPN: node and link genes with innovation numbers, and what makes one valid.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <stdexcept>
#include <string>
#include <tools/gait_evolution/activation.hpp>
#include <trophic/params/params.hpp>
#include <tuple>
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

  [[nodiscard]] bool has_node(std::uint32_t id) const {
    return id < inputs || std::ranges::binary_search(nodes, id, {}, &NodeGene::id);
  }
  /// The link between two nodes, disabled ones included, or links.end().
  [[nodiscard]] auto find_link(std::uint32_t from, std::uint32_t to) const {
    return std::ranges::find_if(links, [=](const LinkGene& link) { return link.from == from && link.to == to; });
  }
};

/// The nodes in an order in which every link, disabled ones included, leads from an earlier node (or an input) to a later one;
/// of the nodes that could come next the smallest id comes first. Shorter than genome.nodes where links form a cycle.
[[nodiscard]] inline std::vector<NodeGene> topological_order(const Genome& genome) {
  std::vector<NodeGene> order;
  std::vector<NodeGene> waiting = genome.nodes;
  const auto ready = [&](const NodeGene& node) {
    return std::ranges::none_of(genome.links, [&](const LinkGene& link) {
      return link.to == node.id && std::ranges::any_of(waiting, [&](const NodeGene& other) { return other.id == link.from; });
    });
  };
  for (;;) {
    const auto next = std::ranges::find_if(waiting, ready);
    if (next == waiting.end()) return order;
    order.push_back(*next);
    waiting.erase(next);
  }
}

/// A node and all that its links, disabled ones included, lead to.
[[nodiscard]] inline std::set<std::uint32_t> reachable_from(const Genome& genome, std::uint32_t node) {
  std::set<std::uint32_t> reached{node};
  std::vector<std::uint32_t> open{node};
  while (!open.empty()) {
    const std::uint32_t from = open.back();
    open.pop_back();
    for (const LinkGene& link : genome.links) {
      if (link.from == from && reached.insert(link.to).second) open.push_back(link.to);
    }
  }
  return reached;
}

/// Throws std::invalid_argument naming gene, value and rule unless: node ids ascend from the output's; innovation numbers
/// ascend; every link joins two existing nodes, leads into no input and out of no output; no two links join the same nodes;
/// weights are finite; no cycle, disabled links included.
inline void validate(const Genome& genome) {
  const auto fail = [](const std::string& gene, const std::string& rule) {
    throw std::invalid_argument{"cppn: " + gene + ": " + rule};
  };
  if (genome.nodes.empty() || genome.nodes.front().id != Genome::output) {
    fail("first node", "must have id " + std::to_string(Genome::output) + ", the output");
  }
  for (std::size_t i = 1; i < genome.nodes.size(); ++i) {
    if (genome.nodes[i].id <= genome.nodes[i - 1].id) fail("node " + std::to_string(genome.nodes[i].id), "ids must ascend");
  }
  for (std::size_t i = 0; i < genome.links.size(); ++i) {
    const LinkGene& link = genome.links[i];
    const std::string gene = "link " + std::to_string(link.innovation);
    if (i > 0 && link.innovation <= genome.links[i - 1].innovation) fail(gene, "innovation numbers must ascend");
    if (!genome.has_node(link.from)) fail(gene, "from = " + std::to_string(link.from) + " is no node of this genome");
    if (!genome.has_node(link.to)) fail(gene, "to = " + std::to_string(link.to) + " is no node of this genome");
    if (link.to < Genome::inputs) fail(gene, "to = " + std::to_string(link.to) + " is an input");
    if (link.from == Genome::output) fail(gene, "from = " + std::to_string(link.from) + " is the output");
    if (!std::isfinite(link.weight)) fail(gene, "weight = " + number_text(link.weight) + " must be finite");
    if (genome.find_link(link.from, link.to) != genome.links.begin() + static_cast<std::ptrdiff_t>(i)) {
      fail(gene, "joins the same nodes as an earlier link");
    }
  }
  if (topological_order(genome).size() != genome.nodes.size()) fail("links", "form a cycle");
}

}  // namespace trophic::gait_evolution
