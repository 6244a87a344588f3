// SPDX-License-Identifier: MIT
// Offspring of two parents whose brains are mixed neuron by neuron.
#pragma once

#include <trophic/reproduction/heredity/crossover.hpp>

namespace trophic::reproduction::heredity {

/// Rule: for each neuron, the bias and all incoming weights come from one random parent: the operator CROSSOVER-NODES
/// [montana1989]. The feature that a neuron detects is thus inherited whole. Gait, body and traits are mixed as in Crossover. The
/// brain must name the neurons of its weights, as every network with a fixed shape does. With one parent, the offspring gets a
/// copy of its genome.   Reads: parents' genomes.   Random draws: those of Crossover; with several parents also one per neuron.
struct CrossoverByNeuron {
  static constexpr std::string_view name = "crossover_by_neuron";
  static constexpr std::string_view source = "not in the paper; [montana1989]";

  static constexpr bool mixes_neurons = true;

  [[nodiscard]] std::shared_ptr<Genome> inherit(std::span<const Ancestor> parents, Rng& rng,
                                                const GenomeStructure& structure) const {
    auto child = Crossover{}.inherit(parents, rng, structure);
    const std::span neurons{structure.neurons};
    const auto has_all = [&](const Ancestor& parent) { return parent.genome->weights.size() == neurons.size(); };
    if (parents.size() == 1 || neurons.empty() || !std::ranges::all_of(parents, has_all)) return child;
    std::vector<const Genome*> from(std::ranges::max(neurons) + 1);
    for (const Genome*& one : from) one = parents[rng.index(parents.size())].genome.get();
    for (std::size_t weight = 0; weight < neurons.size(); ++weight)
      child->weights[weight] = from[neurons[weight]]->weights[weight];
    return child;
  }
};
static_assert(Heredity<CrossoverByNeuron>);

}  // namespace trophic::reproduction::heredity
