// SPDX-License-Identifier: MIT
// Draws and mutates heritable traits.
#pragma once

#include <trophic/rules/table.hpp>
#include <trophic/support/rule_error.hpp>

namespace trophic {

/// A genome's traits under the rule Traits of a table.
template <class Rules>
class TraitGenes {
 public:
  static constexpr std::span<const std::string_view> names = AnswersForSpecies<PolicyIn<Rules, RuleSlot::traits>>::trait_names;

  TraitGenes(const Policies<Rules>& rules, std::uint64_t seed) : rules_{rules}, seed_{seed} {}

  /// Draws the traits of a newborn that has none and mutates inherited ones, by the stream of the individual `as`.
  void draw_or_mutate(Genome& genome, const Individual& born, IndividualId as) const {
    if (names.empty()) return;
    const auto& rule = for_species(rules_.traits, born.species);
    Rng rng{seed_, Stream::traits, as};
    if (genome.traits.empty()) {
      genome.traits = rule.draw(rng);
    } else if (genome.traits.size() == names.size()) {
      rule.mutate(genome.traits, rng);
    }
    if (genome.traits.size() != names.size())
      throw RuleError{"traits", std::to_string(genome.traits.size()) + " traits: must be " + std::to_string(names.size())};
    check_finite("traits", "traits", genome.traits);
  }

 private:
  const Policies<Rules>& rules_;
  std::uint64_t seed_;
};

}  // namespace trophic
