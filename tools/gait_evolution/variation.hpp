// SPDX-License-Identifier: MIT
// How CPPN genomes come to be: random founders, mutation, crossover.
#pragma once

#include <algorithm>
#include <cstdint>
#include <set>
#include <tools/gait_evolution/genome.hpp>
#include <tools/gait_evolution/innovations.hpp>
#include <trophic/params/params.hpp>
#include <trophic/support/rng.hpp>
#include <tuple>
#include <vector>

namespace trophic::gait_evolution {

/// The paper is silent about all of these; the defaults are in the range of [stanley2002].
struct Variation {
  double initial_weight_limit = 1.0;
  double crossover_probability = 0.75;
  double weight_mutation_probability = 0.8;
  double weight_standard_deviation = 0.3;
  double weight_replacement_probability = 0.05;
  double weight_limit = 8.0;
  double add_link_probability = 0.2;
  double add_node_probability = 0.1;
  double activation_mutation_probability = 0.05;

  static constexpr auto fields() {
    using V = Variation;
    return std::tuple{
        field("initial_weight_limit", &V::initial_weight_limit, at_least(0), "founders' weights are uniform in +- this"),
        field("crossover_probability", &V::crossover_probability, between(0, 1), "that a child has two parents"),
        field("weight_mutation_probability", &V::weight_mutation_probability, between(0, 1), "of each link"),
        field("weight_standard_deviation", &V::weight_standard_deviation, at_least(0), "of the normal perturbation"),
        field("weight_replacement_probability", &V::weight_replacement_probability, between(0, 1),
              "that a mutated weight is drawn anew as a founder's"),
        field("weight_limit", &V::weight_limit, above(0), "mutated weights are clipped to +- this"),
        field("add_link_probability", &V::add_link_probability, between(0, 1), "of each child"),
        field("add_node_probability", &V::add_node_probability, between(0, 1), "of each child"),
        field("activation_mutation_probability", &V::activation_mutation_probability, between(0, 1), "of each hidden node")};
  }
};

/// A founder: every input linked to the output, a sine (as the paper's own gait has it), weights uniform in
/// +-initial_weight_limit. 7 draws.
[[nodiscard]] inline Genome random_genome(const Variation& variation, Innovations& innovations, Rng& rng) {
  Genome genome{.nodes = {{Genome::output, Activation::sine}}, .links = {}};
  for (std::uint32_t input = 0; input < Genome::inputs; ++input) {
    genome.links.push_back({.innovation = innovations.link(input, Genome::output),
                            .from = input,
                            .to = Genome::output,
                            .weight = rng.uniform(-variation.initial_weight_limit, variation.initial_weight_limit)});
  }
  return genome;
}

namespace detail {

inline LinkGene& insert(Genome& genome, const LinkGene& link) {
  const auto place = std::ranges::upper_bound(genome.links, link.innovation, {}, &LinkGene::innovation);
  return *genome.links.insert(place, link);
}

}  // namespace detail

/// Perturbs each weight by a normal number with weight_mutation_probability, or replaces it. 1 to 4 draws a link.
inline void mutate_weights(Genome& genome, const Variation& variation, Rng& rng) {
  for (LinkGene& link : genome.links) {
    if (!rng.chance(variation.weight_mutation_probability)) continue;
    const bool replaced = rng.chance(variation.weight_replacement_probability);
    link.weight = replaced ? rng.uniform(-variation.initial_weight_limit, variation.initial_weight_limit)
                           : link.weight + rng.normal(0.0, variation.weight_standard_deviation);
    link.weight = std::clamp(link.weight, -variation.weight_limit, variation.weight_limit);
  }
}

/// Gives each hidden node, with activation_mutation_probability, an activation drawn from all six. 1 or 2 draws a hidden node.
inline void mutate_activations(Genome& genome, const Variation& variation, Rng& rng) {
  for (NodeGene& node : genome.nodes) {
    if (node.id == Genome::output || !rng.chance(variation.activation_mutation_probability)) continue;
    node.activation = all_activations[rng.index(all_activations.size())];
  }
}

/// Splits an enabled link: it is disabled, a new node with a random activation takes its place, the link in has weight 1 and
/// the link out the old weight. Nothing happens where no link is enabled. 2 draws.
inline void add_node(Genome& genome, Innovations& innovations, Rng& rng) {
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
  detail::insert(genome, {innovations.link(old.from, node.id), old.from, node.id, 1.0});
  detail::insert(genome, {innovations.link(node.id, old.to), node.id, old.to, old.weight});
}

/// Links two nodes that no enabled link joins and whose link closes no cycle, each such pair as probable; a disabled link is
/// enabled again. The weight is drawn as a founder's. Nothing happens where no pair is left. 2 draws.
inline void add_link(Genome& genome, const Variation& variation, Innovations& innovations, Rng& rng) {
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
    detail::insert(genome, {innovations.link(from, to), from, to, weight});
  } else {
    LinkGene& link = genome.links[static_cast<std::size_t>(known - genome.links.begin())];
    link.weight = weight;
    link.enabled = true;
  }
}

/// Weights, activations, then a new link and a new node with their probabilities.
inline void mutate(Genome& genome, const Variation& variation, Innovations& innovations, Rng& rng) {
  mutate_weights(genome, variation, rng);
  mutate_activations(genome, variation, rng);
  if (rng.chance(variation.add_link_probability)) add_link(genome, variation, innovations, rng);
  if (rng.chance(variation.add_node_probability)) add_node(genome, innovations, rng);
}

/// The child of two parents: the fitter one's nodes and links (so it is acyclic, as that parent is); a gene that the other has
/// too comes from either with probability 1/2. One draw for each gene that both have.
[[nodiscard]] inline Genome crossover(const Genome& fitter, const Genome& other, Rng& rng) {
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
