// SPDX-License-Identifier: MIT
// The genome of a CPPN: genes with innovation numbers, by which two genomes can be crossed.
#pragma once

#include <map>
#include <trophic/control/cppn.hpp>
#include <trophic/params/params.hpp>
#include <trophic/support/rng.hpp>
#include <vector>

namespace trophic::gait_evolution {

using control::Activation;

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

/// The genes of networks that grow [stanley2002] (Sec. "Targeted Steering": CPPNs). Seven inputs, nodes 0 to 6 as control::Cppn
/// has them; one output, node 7, a sine; hidden nodes from 8 on. Links, disabled ones included, form no cycle; no two join the
/// same nodes.
struct Genome {
  static constexpr std::uint32_t inputs = control::Cppn::inputs;
  static constexpr std::uint32_t output = inputs;

  std::vector<NodeGene> nodes;  ///< output and hidden, ids ascending
  std::vector<LinkGene> links;  ///< innovation numbers ascending

  friend bool operator==(const Genome&, const Genome&) = default;

  /// The network: each node sums its enabled links in the order of their innovation numbers. Throws std::invalid_argument for
  /// links that form a cycle.
  [[nodiscard]] control::Cppn network() const;
};

/// The record of all innovations of a run: the same innovation has the same number in every genome. The links from each input to
/// the output are the numbers 0 to 6.
class Innovations {
 public:
  using Ends = std::pair<std::uint32_t, std::uint32_t>;  ///< from, to

  Innovations();

  /// The number of the link between two nodes; a new one where no genome has had it.
  std::uint32_t link(std::uint32_t from, std::uint32_t to);

  /// The id of the node that splits a link of `genome`: the first one ever made there that the genome lacks, or a new one.
  std::uint32_t node(std::uint32_t split_link, const Genome& genome);

  friend bool operator==(const Innovations&, const Innovations&) = default;

 private:
  std::map<Ends, std::uint32_t> links_;
  std::vector<std::uint32_t> splits_;  ///< the link that each hidden node split first, by id
};

/// How genomes vary. The paper is silent about all of these; the defaults are in the range of [stanley2002].
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
        field("initial_weight_limit", &V::initial_weight_limit, at_least(0),
              "founders' weights are uniform within +- this value"),
        field("crossover_probability", &V::crossover_probability, between(0, 1), "probability that a child has two parents"),
        field("weight_mutation_probability", &V::weight_mutation_probability, between(0, 1),
              "probability that a link's weight mutates"),
        field("weight_standard_deviation", &V::weight_standard_deviation, at_least(0),
              "standard deviation of the normal perturbation"),
        field("weight_replacement_probability", &V::weight_replacement_probability, between(0, 1),
              "probability that a mutated weight is redrawn like a founder's"),
        field("weight_limit", &V::weight_limit, above(0), "mutated weights are clipped to +- this value"),
        field("add_link_probability", &V::add_link_probability, between(0, 1), "probability that a child gets a new link"),
        field("add_node_probability", &V::add_node_probability, between(0, 1), "probability that a child gets a new node"),
        field("activation_mutation_probability", &V::activation_mutation_probability, between(0, 1),
              "probability that a hidden node changes its activation")};
  }
};

/// A founder: every input linked to the output, weights uniform in +-initial_weight_limit. 7 draws.
[[nodiscard]] Genome random_genome(const Variation& variation, Innovations& innovations, Rng& rng);

/// Splits an enabled link: it is disabled, a new node with a random activation takes its place, the link in has weight 1 and
/// the link out the old weight. Nothing happens where no link is enabled. 2 draws.
void add_node(Genome& genome, Innovations& innovations, Rng& rng);

/// Links two nodes that no enabled link joins and whose link closes no cycle, each such pair as probable; a disabled link is
/// enabled again. The weight is drawn as a founder's. Nothing happens where no pair is left. 2 draws.
void add_link(Genome& genome, const Variation& variation, Innovations& innovations, Rng& rng);

/// Perturbs each weight by a normal number, or replaces it (1 to 4 draws a link); gives hidden nodes an activation drawn from
/// all six (1 or 2 draws each); then a new link and a new node, each with its probability.
void mutate(Genome& genome, const Variation& variation, Innovations& innovations, Rng& rng);

/// The child of two parents: the fitter one's nodes and links (so it is acyclic, as that parent is); a gene that the other has
/// too comes from either with probability 1/2. One draw for each gene that both have.
[[nodiscard]] Genome crossover(const Genome& fitter, const Genome& other, Rng& rng);

}  // namespace trophic::gait_evolution
