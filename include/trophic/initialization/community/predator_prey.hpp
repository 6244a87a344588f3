// SPDX-License-Identifier: MIT
// The paper's two species.
#pragma once

#include <trophic/initialization/community/contract.hpp>
#include <trophic/params/params.hpp>

namespace trophic::initialization::community {

/// Predators eat prey. Rule: of N bodies the first N - predators start as prey, the others as predators; 16 and 14 of 30 in
/// the paper (Sec. "Initialization").   Reads: nothing.   Random draws: 0.
struct PredatorPrey {
  static constexpr std::string_view name = "predator_prey";
  static constexpr std::string_view source = "paper, Sec. \"Initialization\"";
  static constexpr Species prey = 0;
  static constexpr Species predator = 1;
  static constexpr std::array<std::string_view, 2> species_names{"prey", "predator"};

  struct Params {
    std::size_t predators = 14;
    static constexpr auto fields() {
      return std::tuple{
          field("predators", &Params::predators, at_least(0), "number of founders that are predators; the others are prey")};
    }
  };
  Params params;

  [[nodiscard]] FoodWeb web() const {
    return {{species_names.begin(), species_names.end()}, {{.hunter = predator, .victim = prey}}};
  }

  [[nodiscard]] std::vector<Species> founders(std::size_t robots) const {
    if (params.predators > robots) {
      throw std::invalid_argument{"rules.community.predators = " + std::to_string(params.predators) +
                                  ": must be <= " + std::to_string(robots) + ", the number of robots"};
    }
    std::vector<Species> species(robots, prey);
    for (std::size_t body = robots - params.predators; body < robots; ++body) species[body] = predator;
    return species;
  }
};
static_assert(Community<PredatorPrey>);

}  // namespace trophic::initialization::community
