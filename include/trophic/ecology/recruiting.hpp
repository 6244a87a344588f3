// SPDX-License-Identifier: MIT
// Births without a death, in a table with a rule Recruitment.
#pragma once

#include <trophic/ecology/turnover.hpp>

namespace trophic {

/// Whether the living parents of a birth have the energy that they must give.
template <class Rules>
[[nodiscard]] bool can_endow(const Population<Rules>& population, const Parentage& parentage) {
  const std::vector<BodyIndex> living = population.bodies_of(parentage.parents);
  if (!has_energy<Rules> || living.empty()) return true;
  const auto payers = parentage.payers(living);
  const double part_J = parentage.endowment_J / static_cast<double>(payers.size());
  return std::ranges::all_of(payers, [&](BodyIndex body) { return part_J <= std::max(population[body].energy_J, 0.0); });
}

/// Gets the births of a tick from the rule Recruitment. Each takes the first spare body; a birth without a body or room, or whose
/// parents have too little energy, is refused and counted. `acting`: the species that may have newborns.
template <class Rules>
void recruit(EcologyState<Rules>& all, Turnover<Rules>& turnover, observe::Audience& audience, const auto& acting) {
  auto& population = all.population;
  Rng rng{all.params.seed, Stream::recruitment, acting.turn, static_cast<std::uint64_t>(all.tick)};
  Rng field_rng{all.params.seed, Stream::resource, 2 + acting.turn, static_cast<std::uint64_t>(all.tick)};
  const auto recruiting = population.states().recruitment.all();
  BodyIndex spare = 0;
  for (const auto& recruit : reproduction::ask::recruits(all.rules.recruitment, recruiting, all.view(), rng)) {
    if (!acting.has(recruit.species) && recruit.species < all.web.size()) continue;
    detail::check_recruit(all.web, all.habitat.arena, recruit,
                          [&](const Ancestor& parent) { return population.misfit(recruit.species, parent.genome.get()); });
    while (spare < population.individuals().size() && population[spare].lives()) ++spare;
    using reproduction::Descent;
    const Parentage parentage{.descent = recruit.parents.empty() ? Descent::random : Descent::of_parent,
                              .parents = recruit.parents,
                              .endowment_J = recruit.endowment_J,
                              .first_pays = recruit.first_pays};
    const bool has_body = spare < population.individuals().size() && can_endow(population, parentage);
    const auto place = recruit.place || !has_body ? recruit.place : turnover.place_of_birth(recruit.parents);
    if (!has_body || !place) {
      ++all.refused_births;
      continue;
    }
    population.replace(spare, recruit.species, parentage, all.view());
    turnover.begin_life(audience, spare, place);
    population.note_birth(recruit.parents, all.view(), field_rng);
  }
  all.bodies.stand();
}

}  // namespace trophic
