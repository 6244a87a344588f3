// SPDX-License-Identifier: MIT
// Finds rules that can never act in a world because of their parameters.
#pragma once

#include <trophic/ecology/experiment.hpp>
#include <trophic/population/outset.hpp>
#include <trophic/population/state.hpp>
#include <trophic/rules/table.hpp>

namespace trophic {

namespace detail {

/// Calls `add` with the sentences of a rule, of its parts, and of each species' rule.
template <class P, class Add>
void for_each_idle(const P& rule, const Outset& outset, const Add& add) {
  if constexpr (!std::same_as<AnswersForSpecies<P>, P>) {
    for (Species species = 0; species < outset.web.size(); ++species)
      for_each_idle(rule.of(species), outset,
                    [&](const std::string& said) { add("for " + outset.web.name(species) + ", " + said); });
  } else if constexpr (MadeOfParts<P>) {
    [&]<std::size_t... place>(std::index_sequence<place...>) {
      (for_each_idle(rule.template part<place>(), outset,
                     [&](const std::string& said) { add(std::string{P::part_names[place]} + "." + said); }),
       ...);
    }
    (std::make_index_sequence<P::part_count>{});
  } else if constexpr (requires {
                         { rule.idle(outset) } -> std::convertible_to<std::string>;
                       }) {
    if (const std::string said = rule.idle(outset); !said.empty()) add(said);
  }
}

/// Predators below their minimum get every prey above the floor, so no prey is left to be caught.
template <class Rules>
[[nodiscard]] std::string idle_captures(const Policies<Rules>& rules, const Outset& outset) {
  if constexpr (requires { rules.minimum_predators.params.below; } && is_neutral<Rules, RuleSlot::recruitment>) {
    std::size_t floor = 0;
    if constexpr (requires { rules.floor.params.floor; }) floor = rules.floor.params.floor;
    const std::size_t below = rules.minimum_predators.params.below;
    if (floor + below >= outset.robots)
      return "rules.floor.floor = " + std::to_string(floor) + " and rules.minimum_predators.below = " + std::to_string(below) +
             ": with " + std::to_string(outset.robots) +
             " robots every prey above the floor is sacrificed, so no prey is left to be caught";
  }
  return {};
}

/// Whether a parent can ever have the energy of a birth.
template <class Rules>
void add_idle_births(const Policies<Rules>& rules, const Outset& outset, std::vector<std::string>& remarks) {
  for (Species species = 0; species < outset.web.size(); ++species) {
    const auto& births = for_species(rules.recruitment, species);
    const auto& metabolism = for_species(rules.metabolism, species);
    if constexpr (requires { births.params.birth_J > metabolism.capacity_J(); }) {
      if (births.params.birth_J > metabolism.capacity_J())
        remarks.push_back("rules.recruitment: no " + outset.web.name(species) +
                          " is ever born: birth_J = " + number_text(births.params.birth_J) +
                          " is above rules.metabolism's capacity_J = " + number_text(metabolism.capacity_J()));
    }
  }
}

/// Diets differ only between foods.
template <class Rules>
[[nodiscard]] std::string idle_diets() {
  using Metabolism = AnswersForSpecies<PolicyIn<Rules, RuleSlot::metabolism>>;
  if constexpr (requires { typename Metabolism::ReadsDiets; }) {
    if (energy::food_names<PolicyIn<Rules, RuleSlot::resource>>.size() < 2)
      return "rules.metabolism: diets have no effect: the table has one food or none (energy::resource::Foods)";
  }
  return {};
}

}  // namespace detail

/// A sentence for each rule that can never act in a world, from the rules themselves (population/outset.hpp) and from the
/// parameters of two rules together.
template <class Rules>
[[nodiscard]] std::vector<std::string> idle_rules(const Policies<Rules>& rules, const Arena& arena, std::size_t robots) {
  const std::size_t spare = reproduction::ask::spare_bodies(rules.recruitment);
  const FoodWeb web = rules.community.web();
  Outset outset{.web = web, .arena = arena, .robots = robots, .founders = std::vector<std::size_t>(web.size())};
  for (const Species species : rules.community.founders(robots - spare)) ++outset.founders.at(species);
  std::vector<std::string> remarks;
#define TROPHIC_ASK_IDLE(Slot, member, ...) \
  detail::for_each_idle(rules.member, outset, [&](const std::string& said) { remarks.push_back("rules." #member ": " + said); });
  TROPHIC_RULE_SLOTS(TROPHIC_ASK_IDLE)
#undef TROPHIC_ASK_IDLE
  if (std::string said = detail::idle_captures<Rules>(rules, outset); !said.empty()) remarks.push_back(std::move(said));
  detail::add_idle_births<Rules>(rules, outset, remarks);
  if (std::string said = detail::idle_diets<Rules>(); !said.empty()) remarks.push_back(std::move(said));
  return remarks;
}

}  // namespace trophic
