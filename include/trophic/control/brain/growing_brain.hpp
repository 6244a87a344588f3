// SPDX-License-Identifier: MIT
// A feed-forward network whose neurons and links are inherited and mutate at birth.
#pragma once

#include <trophic/control/brain/contract.hpp>
#include <trophic/control/brain/detail/network.hpp>
#include <trophic/control/brain/detail/network_genes.hpp>

namespace trophic::control::brain {

/// Rule: neuron i = tanh(sum of weight * neuron before, over its links), without biases, in the order inputs, hidden neurons,
/// output neurons; a link leads from a neuron to a later one. Target angle and tag are as in CognitiveBrain. The first genomes
/// have `hidden` neurons in one layer (0: inputs are linked to outputs), so 3 gives the paper's network. At a birth with
/// inheritance, after the rule Mutation has changed the weights, each operator acts with its probability, in this order, if
/// possible:
///   add_link       a link between two unlinked neurons, of weight N(0, new_weight_sd)   3 draws
///   remove_link    a link                                                                      1 draw
///   split_link     a neuron in a link: weight 1 before it, the link's weight after it          1 draw
///   remove_neuron  a hidden neuron with its links                                              1 draw
/// This follows NEAT [stanley2002], without its crossover and innovation numbers.
/// Genome: hidden neurons, then the two ends of each link, then the weight of each link; links ascend by end, then by start.
/// Reads: the sensors.   Random draws: 4 at a birth, plus those above.
struct GrowingBrain {
  static constexpr std::string_view name = "growing_brain";
  static constexpr std::string_view source = "not in the paper; operators after [stanley2002]";

  struct Params {
    std::size_t hidden = 3;
    std::size_t most_hidden = 30;
    double add_link = 0.1;
    double remove_link = 0.1;
    double split_link = 0.03;
    double remove_neuron = 0.03;
    double new_weight_sd = 0.5;
    double turn_angle_rad = 0.7;
    static constexpr auto fields() {
      return std::tuple{
          field("hidden", &Params::hidden, between(0.0, 100.0), "number of hidden neurons in the first genomes")
              .read_for_newcomers(),
          field("most_hidden", &Params::most_hidden, between(0.0, 100.0), "maximum number of hidden neurons in a genome"),
          field("add_link", &Params::add_link, between(0.0, 1.0), "probability of a new link"),
          field("remove_link", &Params::remove_link, between(0.0, 1.0), "probability of losing a link"),
          field("split_link", &Params::split_link, between(0.0, 1.0), "probability of a new neuron that splits a link"),
          field("remove_neuron", &Params::remove_neuron, between(0.0, 1.0), "probability of losing a neuron"),
          field("new_weight_sd", &Params::new_weight_sd, at_least(0.0), "standard deviation of a new link's weight"),
          field("turn_angle_rad", &Params::turn_angle_rad, between(0.0, 3.141592653589793),
                "absolute value of the target angle")};
    }
  };
  Params params;

  [[nodiscard]] std::vector<int> tags() const { return {-1, 1}; }

  /// Returns a genome of the first generation with all weights 0.   Random draws: 0.
  [[nodiscard]] std::vector<double> first(std::size_t inputs, std::size_t outputs, Rng&) const {
    return detail::layered_genes(inputs, std::min(params.hidden, params.most_hidden), outputs);
  }

  /// Returns whether these genes are a valid network for this brain.
  [[nodiscard]] bool fits(std::span<const double> genes, std::size_t inputs, std::size_t outputs) const {
    return detail::are_network(genes, inputs, outputs, params.most_hidden);
  }

  /// Returns the weights among the genes: the numbers that the rules InitialGenome and Mutation may change.
  [[nodiscard]] std::span<double> weights_of(std::span<double> genes) const { return genes.last(genes.size() / 3); }

  void mutate_structure(std::vector<double>& genes, std::size_t inputs, std::size_t outputs, Rng& rng) const {
    detail::Network network{genes, inputs, outputs};
    if (rng.chance(params.add_link)) network.add_link(params.new_weight_sd, rng);
    if (rng.chance(params.remove_link)) network.remove_link(rng);
    if (rng.chance(params.split_link) && network.hidden() < params.most_hidden) network.split_link(rng);
    if (rng.chance(params.remove_neuron)) network.remove_neuron(rng);
    genes = network.genes();
  }

  /// Returns the distance between the weights of two genomes, with links matched by their neurons (detail/network_genes.hpp).
  [[nodiscard]] double distance(std::span<const double> a, std::span<const double> b) const {
    return detail::network_distance(a, b);
  }

  /// Each output is in (-1, 1).
  void evaluate(std::span<const double> inputs, std::span<const double> genes, std::span<double> outputs) const {
    const std::vector<double> neurons = detail::network_neurons(inputs, genes, outputs.size());
    std::ranges::copy(std::span{neurons}.last(outputs.size()), outputs.begin());
  }
  [[nodiscard]] double target_angle_rad(double output) const { return detail::either_side(output, params.turn_angle_rad); }

  /// Calls `visit(gene's index, neuron before, neuron after)` for each link.
  template <class Visit>
  void for_each_link(std::span<const double> inputs, std::span<const double> genes, const Visit& visit) const {
    const std::size_t links = genes.size() / 3;
    if (links == 0) return;
    const std::size_t outputs = static_cast<std::size_t>(genes[2 * links] - genes[0]) + 1 - inputs.size();
    const std::vector<double> neurons = detail::network_neurons(inputs, genes, outputs);
    for (std::size_t link = 0; link < links; ++link) {
      visit(1 + 2 * links + link, neurons[static_cast<std::size_t>(genes[1 + 2 * link])],
            neurons[static_cast<std::size_t>(genes[2 + 2 * link])]);
    }
  }
};
static_assert(Brain<GrowingBrain>);

}  // namespace trophic::control::brain
