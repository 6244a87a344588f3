// SPDX-License-Identifier: MIT
// Draws and mutates heritable traits.
#pragma once

#include <trophic/population/food_web.hpp>
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

  /// Throws std::invalid_argument naming a bound that living individuals are beyond, as in a run that continues another one with
  /// narrower bounds, and their number.
  void check_bounds([[maybe_unused]] std::span<const Individual> individuals, [[maybe_unused]] const FoodWeb& web) const {
    using Policy = PolicyIn<Rules, RuleSlot::traits>;
    if constexpr (reproduction::BoundsTraits<AnswersForSpecies<Policy>>) {
      std::string bound;
      reproduction::BeyondBound farthest;
      std::size_t count = 0;
      for (const Individual& one : individuals) {
        const auto beyond = one.lives() ? for_species(rules_.traits, one.species).beyond(one.genome->traits) : std::nullopt;
        if (!beyond) continue;
        const bool differ = !std::same_as<AnswersForSpecies<Policy>, Policy>;
        const std::string its_bound = (differ ? web.name(one.species) + "." : "") + beyond->parameter;
        if (count > 0 && its_bound != bound) continue;
        bound = its_bound;
        if (count++ == 0 || std::abs(beyond->trait - beyond->bound) > std::abs(farthest.trait - farthest.bound))
          farthest = *beyond;
      }
      if (count == 0) return;
      throw std::invalid_argument{"rules.traits." + bound + " = " + number_text(farthest.bound) + ": must be " +
                                  (farthest.trait < farthest.bound ? "<= " : ">= ") + number_text(farthest.trait) + ", as " +
                                  std::to_string(count) + " living individuals have traits beyond it"};
    }
  }

 private:
  const Policies<Rules>& rules_;
  std::uint64_t seed_;
};

}  // namespace trophic
