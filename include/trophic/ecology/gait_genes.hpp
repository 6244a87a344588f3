// SPDX-License-Identifier: MIT
// Draws, mutates and expresses the genes of gaits.
#pragma once

#include <trophic/control/gait/contract.hpp>
#include <trophic/rules/table.hpp>
#include <trophic/support/rule_error.hpp>

namespace trophic {

/// A genome's gait under the rule Gait of a table.
template <class Rules>
class GaitGenes {
 public:
  using Rule = AnswersForSpecies<PolicyIn<Rules, RuleSlot::gait>>;
  static constexpr bool are_inherited = control::InheritedGait<Rule>;
  static constexpr bool are_learnt = control::LearntGait<Rule>;
  /// Whether individuals have their own gaits.
  static constexpr bool differ = !is_neutral<Rules, RuleSlot::gait> || !is_neutral<Rules, RuleSlot::body_plan>;

  GaitGenes(const Policies<Rules>& rules, const Habitat* habitat, const Nursery* nursery)
      : rules_{rules}, habitat_{habitat}, nursery_{nursery} {}

  /// Draws the genes of a newborn that has none, mutates inherited ones, and lets the newborn learn.
  void draw_or_mutate(std::vector<double>& genes, const RobotModel& robot, const Individual& born, Rng& rng) const {
    if constexpr (are_inherited) {
      const Rule& rule = for_species(rules_.gait, born.species);
      if (genes.empty()) {
        genes = rule.draw(robot, *habitat_, rng);
      } else {
        rule.mutate(genes, born, rng);
      }
      if constexpr (are_learnt) rule.learn(genes, robot, *habitat_, born, *nursery_, rng);
      if (genes.empty()) throw RuleError{"gait", "no genes: must have at least one"};
      check_finite("gait", "genes", genes);
    }
  }

  /// The indices of the genes that are structure.
  [[nodiscard]] std::vector<std::size_t> structure(Species species, std::span<const double> genes) const {
    if constexpr (are_inherited) {
      std::vector<std::size_t> indices = control::ask::gait_structure(for_species(rules_.gait, species), genes);
      for (const std::size_t gene : indices) check_index("gait", "a gene of the structure", gene, genes.size());
      return indices;
    }
    return {};
  }

  /// Returns the gait of these genes. Throws std::invalid_argument for genes from different rules.
  [[nodiscard]] std::shared_ptr<const Gait> express(Species species, std::span<const double> genes,
                                                    const RobotModel& robot) const {
    auto gait = std::make_shared<Gait>(for_species(rules_.gait, species).express(genes, robot, *habitat_));
    check_fit(*gait, robot);
    return gait;
  }

 private:
  const Policies<Rules>& rules_;
  const Habitat* habitat_;
  const Nursery* nursery_;
};

}  // namespace trophic
