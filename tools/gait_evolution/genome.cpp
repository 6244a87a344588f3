// SPDX-License-Identifier: MIT
// Definitions of genome.hpp.
#include <tools/gait_evolution/genome.hpp>

#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace trophic::gait_evolution {

bool Genome::has_node(std::uint32_t id) const {
  return id < inputs || std::ranges::binary_search(nodes, id, {}, &NodeGene::id);
}

std::vector<NodeGene> topological_order(const Genome& genome) {
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

std::set<std::uint32_t> reachable_from(const Genome& genome, std::uint32_t node) {
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

void validate(const Genome& genome) {
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
    if (!genome.has_node(link.from)) fail(gene, "from = " + std::to_string(link.from) + " is not a node of this genome");
    if (!genome.has_node(link.to)) fail(gene, "to = " + std::to_string(link.to) + " is not a node of this genome");
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
