// SPDX-License-Identifier: MIT
// Draws and mutates the weights of brains.
#pragma once

#include <trophic/control/brain/contract.hpp>
#include <trophic/reproduction/heredity/contract.hpp>
#include <trophic/reproduction/initial_genome/contract.hpp>
#include <trophic/reproduction/mutation/contract.hpp>
#include <trophic/rules/table.hpp>
#include <trophic/support/rule_error.hpp>

namespace trophic {

/// A genome's weights under the rules Brain, InitialGenome and Mutation of a table.
template <class Rules>
class BrainGenes {
 public:
  using Brain = AnswersForSpecies<PolicyIn<Rules, RuleSlot::brain>>;
  static constexpr bool grow = control::GrowingBrain<Brain>;  ///< whether their number may change
  static constexpr bool mix_neurons =
      reproduction::MixesNeurons<AnswersForSpecies<PolicyIn<Rules, RuleSlot::heredity>>>;  ///< with several parents
  static_assert(!mix_neurons || control::NamesNeurons<Brain>,
                "the policy in Rules::Heredity mixes brains by neuron, so the policy in Rules::Brain needs "
                "std::vector<std::size_t> neurons(std::size_t inputs, std::size_t outputs) const; see "
                "trophic/control/brain/contract.hpp");

  BrainGenes(const Policies<Rules>& rules, std::uint64_t seed) : rules_{rules}, seed_{seed} {}

  /// Draws the weights of an individual without a parent, by the streams of the individual `as`.
  void draw(Genome& genome, const Individual& born, IndividualId as) const {
    Rng structure{seed_, Stream::brain_structure, as};
    Rng rng{seed_, Stream::initial_genome, as};
    const Brain& brain = brain_of(born.species);
    genome.weights = control::ask::first_genes(brain, shape_of(born.species), structure);
    reproduction::ask::draw(rules_.initial_genome, control::ask::weights_of(brain, genome.weights), born, rng);
    check_finite("initial_genome", "weights", genome.weights);
  }

  /// Draws the weights of a newborn that has none, else mutates them; `own` is its state of the rule Mutation.
  template <class State>
  void draw_or_mutate(Genome& genome, State& own, const Individual& born) const {
    if (genome.weights.empty()) return draw(genome, born, born.id);
    Rng rng{seed_, Stream::mutation, born.id};
    Rng growth{seed_, Stream::brain_growth, born.id};
    const Brain& brain = brain_of(born.species);
    reproduction::ask::mutate(rules_.mutation, own, control::ask::weights_of(brain, genome.weights), born, rng);
    control::ask::mutate_structure(brain, genome.weights, shape_of(born.species), growth);
    check_finite("mutation", "weights", genome.weights);
  }

  /// The demand of a species' brain that a genome violates, "a genome of 15 weights"; none if it fits. Null violates it.
  [[nodiscard]] std::optional<std::string> misfit(Species species, const Genome* genome) const {
    const Brain& brain = brain_of(species);
    const control::BrainShape shape = shape_of(species);
    if (genome != nullptr && control::ask::fits(brain, genome->weights, shape)) return std::nullopt;
    return control::ask::demand(brain, shape);
  }

  /// The weights of the largest brain of so many species; none if brains grow.
  [[nodiscard]] std::optional<std::size_t> most(std::size_t species) const {
    if constexpr (grow) {
      return std::nullopt;
    } else {
      std::size_t most = 0;
      for (Species one = 0; one < species; ++one)
        most = std::max(most, brain_of(one).genome_size(shape_of(one).inputs, shape_of(one).outputs));
      return most;
    }
  }

  /// Sets the structure of a species' weights.
  void describe(reproduction::GenomeStructure& structure, Species species, const std::vector<double>& weights) const {
    const Brain& brain = brain_of(species);
    structure.weights = control::ask::weight_structure(brain, weights);
    if constexpr (mix_neurons && control::NamesNeurons<Brain>)
      structure.neurons = brain.neurons(shape_of(species).inputs, shape_of(species).outputs);
  }

  /// The distance between the weights of a parent and of its offspring.
  [[nodiscard]] double distance(Species species, std::span<const double> before, std::span<const double> after) const {
    const double distance = control::ask::distance(brain_of(species), before, after);
    check_finite("brain", "a distance between weights", {&distance, 1});
    return distance;
  }

 private:
  [[nodiscard]] static control::BrainShape shape_of(Species species) {
    return {.inputs = PolicyIn<Rules, RuleSlot::sensors>::size_of(species), .outputs = PolicyIn<Rules, RuleSlot::acts>::outputs};
  }
  [[nodiscard]] const Brain& brain_of(Species species) const { return for_species(rules_.brain, species); }

  const Policies<Rules>& rules_;
  std::uint64_t seed_;
};

}  // namespace trophic
