// SPDX-License-Identifier: MIT
// Behavioural signatures: types of genomes by what their brains decide.
#pragma once

#include <functional>
#include <tools/reading/met_inputs.hpp>
#include <trophic/population/food_web.hpp>
#include <unordered_map>

namespace trophic::analysis {

/// The acts of a species' brain for these inputs with the weights of a genome, a whole number each: AskBrain in
/// trophic/experiment/any_experiment.hpp.
using Decide = std::function<std::vector<int>(Species species, std::span<const double> inputs, std::span<const double> weights)>;

/// A type of genomes; equal numbers are equal types.
using Type = std::uint32_t;

/// Types of the genomes of each species. Weights are real numbers, so that each birth has a new genome, and genomes are not
/// types. Two genomes are of one type if their brains do the same in every act for each of a list of inputs: turn to the same
/// side, show the same tag. A brain with a state is asked with its initial one.
class Signatures {
 public:
  /// @param inputs by species.
  Signatures(Decide decide, std::vector<std::vector<Inputs>> inputs);

  [[nodiscard]] Type type_of(Species species, std::span<const double> weights);

  /// How many pairs of an input and an act of the brain depend on each other: at one of the inputs met, the
  /// act changes when the input is replaced by its smallest or greatest value.
  [[nodiscard]] std::size_t complexity(Species species, std::span<const double> weights) const;

 private:
  Decide decide_;
  std::vector<std::vector<Inputs>> inputs_;
  std::vector<std::vector<Inputs>> extremes_;  ///< by species: the smallest and the greatest value of each input
  std::unordered_map<std::string, Type> types_;
};

}  // namespace trophic::analysis
