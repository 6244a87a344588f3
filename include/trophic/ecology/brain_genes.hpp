// SPDX-License-Identifier: MIT
// Draws and mutates the weights of brains.
#pragma once

#include <trophic/control/brain/contract.hpp>
#include <trophic/reproduction/initial_genome/contract.hpp>
#include <trophic/reproduction/mutation/contract.hpp>
#include <trophic/rules/table.hpp>
#include <trophic/support/rule_error.hpp>

namespace trophic {

/// A genome's weights under the rules Brain, InitialGenome and Mutation of a table.
template <class Rules>
class BrainGenes {
 public:
  using Brain = PolicyIn<Rules, RuleSlot::brain>;
  static constexpr bool grow = control::GrowingBrain<Brain>;  ///< whether their number may change

  BrainGenes(const Policies<Rules>& rules, std::uint64_t seed) : rules_{rules}, seed_{seed} {}

  /// Draws the weights of an individual without a parent.
  void draw(Genome& genome, const Individual& born) const {
    Rng structure{seed_, Stream::brain_structure, born.id};
    Rng rng{seed_, Stream::initial_genome, born.id};
    genome.weights = control::ask::first_genes(rules_.brain, inputs, structure);
    reproduction::ask::draw(rules_.initial_genome, control::ask::weights_of(rules_.brain, genome.weights), born, rng);
    check_finite("initial_genome", "weights", genome.weights);
  }

  /// Mutates inherited weights; `own` is the offspring's state of the rule Mutation.
  template <class State>
  void mutate(Genome& genome, State& own, const Individual& born) const {
    Rng rng{seed_, Stream::mutation, born.id};
    Rng growth{seed_, Stream::brain_growth, born.id};
    reproduction::ask::mutate(rules_.mutation, own, control::ask::weights_of(rules_.brain, genome.weights), born, rng);
    control::ask::mutate_structure(rules_.brain, genome.weights, inputs, growth);
    check_finite("mutation", "weights", genome.weights);
  }

  /// The demand of the brain that a genome violates, "a genome of 15 weights"; none if it fits. Null violates it.
  [[nodiscard]] std::optional<std::string> misfit(const Genome* genome) const {
    if (genome != nullptr && control::ask::fits(rules_.brain, genome->weights, inputs)) return std::nullopt;
    return control::ask::demand(rules_.brain, inputs);
  }

  /// The distance between the weights of a parent and of its offspring.
  [[nodiscard]] double distance(std::span<const double> before, std::span<const double> after) const {
    const double distance = control::ask::distance(rules_.brain, before, after);
    check_finite("brain", "a distance between weights", {&distance, 1});
    return distance;
  }

 private:
  static constexpr std::size_t inputs = PolicyIn<Rules, RuleSlot::sensors>::size;

  const Policies<Rules>& rules_;
  std::uint64_t seed_;
};

}  // namespace trophic
