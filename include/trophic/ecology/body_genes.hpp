// SPDX-License-Identifier: MIT
// Draws, mutates and expresses the genes of bodies.
#pragma once

#include <trophic/population/phenotype.hpp>
#include <trophic/reproduction/body_plan/contract.hpp>
#include <trophic/reproduction/viability/contract.hpp>
#include <trophic/rules/table.hpp>
#include <trophic/support/rule_error.hpp>

namespace trophic {

/// A genome's body under the rules BodyPlan and Viability of a table.
template <class Rules>
class BodyGenes {
 public:
  using Plan = AnswersForSpecies<PolicyIn<Rules, RuleSlot::body_plan>>;
  static constexpr bool are_inherited = reproduction::InheritedBody<Plan>;
  static constexpr bool differ = !is_neutral<Rules, RuleSlot::body_plan>;  ///< whether individuals have their own bodies
  static constexpr std::size_t most_draws = 1000;                          ///< for a body without a parent

  BodyGenes(const Policies<Rules>& rules, const Habitat* habitat) : rules_{rules}, habitat_{habitat} {}

  /// Draws the genes of a newborn that has none and mutates inherited ones until the body is viable. Returns the body that they
  /// express. `refused` counts mutations that were refused.
  [[nodiscard]] Phenotype draw_or_mutate(std::vector<double>& genes, const Individual& born, Rng& rng,
                                         std::uint64_t& refused) const {
    if constexpr (are_inherited) {
      const Plan& plan = for_species(rules_.body_plan, born.species);
      const std::vector<double> parents = genes;
      const bool is_drawn = parents.empty();
      const std::size_t attempts = is_drawn ? most_draws : for_species(rules_.viability, born.species).attempts();
      std::string refusal;
      for (std::size_t attempt = 0; attempt < attempts; ++attempt) {
        if (is_drawn) {
          genes = plan.draw(born.species, *habitat_, rng);
        } else {
          plan.mutate(genes, born, *habitat_, rng);
        }
        check_finite("body_plan", "genes", genes);
        if (Phenotype own = viable(born.species, genes, refusal); own.robot) return own;
        refused += is_drawn ? 0 : 1;
        genes = parents;
      }
      if (is_drawn) throw_refused("bodies", refusal);
    }
    return express(born.species, genes);
  }

  /// The body of these genes, nothing if bodies do not differ. Throws std::invalid_argument if it cannot be built.
  [[nodiscard]] Phenotype express(Species species, std::span<const double> genes) const {
    if (!differ) return {};
    auto design = std::make_shared<body::Design>(for_species(rules_.body_plan, species).grow(genes, species, *habitat_));
    auto robot = std::make_shared<RobotModel>(body::build(*design));
    if (robot->hinges.empty()) throw std::invalid_argument{"robot " + robot->name + ": no hinges, must be >= 1"};
    return {.individual = 0, .design = std::move(design), .robot = std::move(robot), .gait = nullptr};
  }

  [[noreturn]] static void throw_refused(std::string_view what, const std::string& refusal) {
    throw RuleError{"body_plan", std::to_string(most_draws) + " random " + std::string{what} +
                                     " in a row were refused, the last one because \"" + refusal +
                                     "\": some bodies must be viable"};
  }

 private:
  /// The body of these genes, or nothing and why none may be born with it.
  [[nodiscard]] Phenotype viable(Species species, std::span<const double> genes, std::string& refusal) const {
    try {
      if (genes.empty()) throw std::invalid_argument{"a core without modules"};
      Phenotype own = express(species, genes);
      const auto reason = for_species(rules_.viability, species).refusal(*own.design, *own.robot);
      if (!reason) return own;
      refusal = *reason;
    } catch (const std::invalid_argument& error) {
      refusal = error.what();
    }
    return {};
  }

  const Policies<Rules>& rules_;
  const Habitat* habitat_;
};

}  // namespace trophic
