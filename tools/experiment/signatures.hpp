// SPDX-License-Identifier: MIT
// Behavioural signatures: types of genomes by what their brains decide.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <tools/command/offers.hpp>
#include <trophic/population/food_web.hpp>
#include <unordered_map>

namespace trophic::command {

/// Inputs of a brain.
using Inputs = std::vector<double>;

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

/// Prints a line for each genome in a file: its type and its complexity by the brain of the rule table that the file names.
///
/// The file is a line of JSON, {"rule_table", "engine", "fingerprint", "params": of the runs, "inputs": of each species,
/// "species" and "sizes": the species and the number of weights of each genome}, and the genomes' weights as doubles.
/// Throws std::invalid_argument, a sentence, if the offer has not that rule table as it was, or if its brain does not take them.
[[nodiscard]] int print_signatures(const std::filesystem::path& file, const Offer& offer);

}  // namespace trophic::command
