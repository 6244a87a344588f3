// SPDX-License-Identifier: MIT
// The start of an ecology: the species and the place of each founder.
#pragma once

#include <trophic/ecology/checks.hpp>
#include <trophic/ecology/experiment.hpp>
#include <trophic/habitat/habitat.hpp>
#include <trophic/population/individual.hpp>
#include <trophic/rules/table.hpp>
#include <trophic/support/rng.hpp>
#include <trophic/support/rule_error.hpp>
#include <trophic/support/units.hpp>

namespace trophic {

/// Returns the species of the founder in each body, no_species for a spare body. Throws RuleError unless there is one per robot,
/// or for a species' name that would break a table.
template <class Rules>
[[nodiscard]] std::vector<Species> founders_of(const Experiment<Rules>& params, const Policies<Rules>& rules,
                                               const FoodWeb& web) {
  detail::check_names(web);
  const std::size_t robots = params.ecology.robots;
  std::vector<Species> species;
  if (!params.lineup.empty()) {
    for (const Contestant& one : params.lineup) species.push_back(one.species);
    detail::check_one_each("community", "individuals of a contest", species.size(), robots);
  } else {
    const std::size_t founders =
        robots - detail::checked_spare_bodies(reproduction::ask::spare_bodies(rules.recruitment), robots);
    species = rules.community.founders(founders);
    detail::check_one_each("community", "founders", species.size(), founders);
  }
  for (const Species one : species) check_index("community", "species", one, web.size());
  species.resize(robots, no_species);
  return species;
}

/// Returns a place for each founder by the Placement rule; a spare body, which is not in the world, has the place of a founder.
/// Throws RuleError for a wrong number of places or one that is not finite.
template <class Rules>
[[nodiscard]] std::vector<GroundPose> places_of(const Experiment<Rules>& params, const Policies<Rules>& rules,
                                                const Habitat& habitat, std::size_t founders) {
  Rng rng{params.seed, Stream::placement};
  auto places = rules.placement.place(founders, habitat.arena, habitat.robot.bounding_radius_m, rng);
  detail::check_places(places, founders);
  for (std::size_t body = founders; body < params.ecology.robots; ++body) places.push_back(places[body - founders]);
  return places;
}

}  // namespace trophic
