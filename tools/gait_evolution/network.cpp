// SPDX-License-Identifier: MIT
// Definitions of network.hpp.
#include <tools/gait_evolution/network.hpp>

#include <unordered_map>

namespace trophic::gait_evolution {

Network::Network(const Genome& genome) {
  validate(genome);
  std::unordered_map<std::uint32_t, std::size_t> slot_of_node;
  for (std::uint32_t input = 0; input < Genome::inputs; ++input) slot_of_node[input] = input;
  for (const NodeGene& gene : topological_order(genome)) {
    Node node{.activation = gene.activation, .incoming = {}};
    for (const LinkGene& link : genome.links) {
      if (link.to == gene.id && link.enabled) node.incoming.push_back({slot_of_node.at(link.from), link.weight});
    }
    slot_of_node[gene.id] = Genome::inputs + nodes_.size();
    nodes_.push_back(std::move(node));
  }
  output_slot_ = slot_of_node.at(Genome::output);
}

}  // namespace trophic::gait_evolution
