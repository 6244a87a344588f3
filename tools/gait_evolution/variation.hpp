// SPDX-License-Identifier: MIT
// How CPPN genomes come to be: random founders, mutation, crossover.
#pragma once

#include <tools/gait_evolution/genome.hpp>
#include <tools/gait_evolution/innovations.hpp>
#include <trophic/params/params.hpp>
#include <trophic/support/rng.hpp>

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
[[nodiscard]] Genome random_genome(const Variation& variation, Innovations& innovations, Rng& rng);

/// Perturbs each weight by a normal number with weight_mutation_probability, or replaces it. 1 to 4 draws a link.
void mutate_weights(Genome& genome, const Variation& variation, Rng& rng);

/// Gives each hidden node, with activation_mutation_probability, an activation drawn from all six. 1 or 2 draws a hidden node.
void mutate_activations(Genome& genome, const Variation& variation, Rng& rng);

/// Splits an enabled link: it is disabled, a new node with a random activation takes its place, the link in has weight 1 and
/// the link out the old weight. Nothing happens where no link is enabled. 2 draws.
void add_node(Genome& genome, Innovations& innovations, Rng& rng);

/// Links two nodes that no enabled link joins and whose link closes no cycle, each such pair as probable; a disabled link is
/// enabled again. The weight is drawn as a founder's. Nothing happens where no pair is left. 2 draws.
void add_link(Genome& genome, const Variation& variation, Innovations& innovations, Rng& rng);

/// Weights, activations, then a new link and a new node with their probabilities.
void mutate(Genome& genome, const Variation& variation, Innovations& innovations, Rng& rng);

/// The child of two parents: the fitter one's nodes and links (so it is acyclic, as that parent is); a gene that the other has
/// too comes from either with probability 1/2. One draw for each gene that both have.
[[nodiscard]] Genome crossover(const Genome& fitter, const Genome& other, Rng& rng);

}  // namespace trophic::gait_evolution
