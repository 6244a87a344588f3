// SPDX-License-Identifier: MIT
// All individuals that ever lived in a pre-experiment.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <tools/gait_evolution/genome.hpp>
#include <tools/gait_evolution/innovations.hpp>
#include <vector>

namespace trophic::gait_evolution {

/// One candidate. Its id is its place in Lineage::individuals.
struct Individual {
  std::vector<std::size_t> parents{};                         ///< ids: none for a founder, else one or two
  std::size_t born = 0;                                       ///< generation
  std::optional<std::size_t> died{};                          ///< generation whose survivor selection it lost; none: it lives
  double fitness = -std::numeric_limits<double>::infinity();  ///< -infinity: its trial diverged
  Genome genome{};

  [[nodiscard]] bool survived(std::size_t generation) const { return born <= generation && (!died || *died > generation); }
  friend bool operator==(const Individual&, const Individual&) = default;
};

/// The whole state of a pre-experiment between two generations.
struct Lineage {
  std::size_t generations = 0;  ///< done: 0 nothing yet, 1 the founders, ...
  std::vector<Individual> individuals;
  Innovations innovations;
  friend bool operator==(const Lineage&, const Lineage&) = default;

  /// Ids of those alive, ascending.
  [[nodiscard]] std::vector<std::size_t> living() const;

  /// The id of the fittest ever; the oldest among equals. At least one individual.
  [[nodiscard]] std::size_t champion() const;
};

}  // namespace trophic::gait_evolution
