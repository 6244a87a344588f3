// SPDX-License-Identifier: MIT
// Definitions of variation.hpp.
#include <tools/gait_evolution/variation.hpp>

#include <algorithm>
#include <set>
#include <vector>

namespace trophic::gait_evolution {

Genome random_genome(const Variation& variation, Innovations& innovations, Rng& rng) {
  Genome genome{.nodes = {{Genome::output, Activation::sine}}, .links = {}};
  for (std::uint32_t input = 0; input < Genome::inputs; ++input) {
    genome.links.push_back({.innovation = innovations.link(input, Genome::output),
                            .from = input,
                            .to = Genome::output,
                            .weight = rng.uniform(-variation.initial_weight_limit, variation.initial_weight_limit)});
  }
  return genome;
}

namespace {

LinkGene& insert(Genome& genome, const LinkGene& link) {
  const auto place = std::ranges::upper_bound(genome.links, link.innovation, {}, &LinkGene::innovation);
  return *genome.links.insert(place, link);
}

}  // namespace

void mutate_weights(Genome& genome, const Variation& variation, Rng& rng) {
  for (LinkGene& link : genome.links) {
    if (!rng.chance(variation.weight_mutation_probability)) continue;
    const bool replaced = rng.chance(variation.weight_replacement_probability);
    link.weight = replaced ? rng.uniform(-variation.initial_weight_limit, variation.initial_weight_limit)
                           : link.weight + rng.normal(0.0, variation.weight_standard_deviation);
    link.weight = std::clamp(link.weight, -variation.weight_limit, variation.weight_limit);
  }
}

void mutate_activations(Genome& genome, const Variation& variation, Rng& rng) {
  for (NodeGene& node : genome.nodes) {
    if (node.id == Genome::output || !rng.chance(variation.activation_mutation_probability)) continue;
    node.activation = all_activations[rng.index(all_activations.size())];
  }
}

void add_node(Genome& genome, Innovations& innovations, Rng& rng) {
  std::vector<std::size_t> enabled;
  for (std::size_t i = 0; i < genome.links.size(); ++i) {
    if (genome.links[i].enabled) enabled.push_back(i);
  }
  if (enabled.empty()) return;
  LinkGene& split = genome.links[enabled[rng.index(enabled.size())]];
  const LinkGene old = split;
  split.enabled = false;
  const NodeGene node{innovations.node(old.innovation, genome), all_activations[rng.index(all_activations.size())]};
  genome.nodes.insert(std::ranges::upper_bound(genome.nodes, node.id, {}, &NodeGene::id), node);
  insert(genome, {innovations.link(old.from, node.id), old.from, node.id, 1.0});
  insert(genome, {innovations.link(node.id, old.to), node.id, old.to, old.weight});
}

void add_link(Genome& genome, const Variation& variation, Innovations& innovations, Rng& rng) {
  std::vector<Innovations::Ends> free;
  for (const NodeGene& to : genome.nodes) {
    const std::set<std::uint32_t> later = reachable_from(genome, to.id);
    const auto offer = [&](std::uint32_t from) {
      const auto known = genome.find_link(from, to.id);
      if (!later.contains(from) && (known == genome.links.end() || !known->enabled)) free.emplace_back(from, to.id);
    };
    for (std::uint32_t input = 0; input < Genome::inputs; ++input) offer(input);
    for (const NodeGene& from : genome.nodes) {
      if (from.id != Genome::output) offer(from.id);
    }
  }
  if (free.empty()) return;
  const auto [from, to] = free[rng.index(free.size())];
  const double weight = rng.uniform(-variation.initial_weight_limit, variation.initial_weight_limit);
  const auto known = genome.find_link(from, to);
  if (known == genome.links.end()) {
    insert(genome, {innovations.link(from, to), from, to, weight});
  } else {
    LinkGene& link = genome.links[static_cast<std::size_t>(known - genome.links.begin())];
    link.weight = weight;
    link.enabled = true;
  }
}

void mutate(Genome& genome, const Variation& variation, Innovations& innovations, Rng& rng) {
  mutate_weights(genome, variation, rng);
  mutate_activations(genome, variation, rng);
  if (rng.chance(variation.add_link_probability)) add_link(genome, variation, innovations, rng);
  if (rng.chance(variation.add_node_probability)) add_node(genome, innovations, rng);
}

Genome crossover(const Genome& fitter, const Genome& other, Rng& rng) {
  Genome child = fitter;
  for (NodeGene& node : child.nodes) {
    const auto match = std::ranges::lower_bound(other.nodes, node.id, {}, &NodeGene::id);
    if (match != other.nodes.end() && match->id == node.id && rng.chance(0.5)) node = *match;
  }
  for (LinkGene& link : child.links) {
    const auto match = std::ranges::lower_bound(other.links, link.innovation, {}, &LinkGene::innovation);
    if (match != other.links.end() && match->innovation == link.innovation && rng.chance(0.5)) link = *match;
  }
  return child;
}

}  // namespace trophic::gait_evolution
