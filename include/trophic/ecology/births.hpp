// SPDX-License-Identifier: MIT
// The origin of a newborn, and the circumstances of all births.
#pragma once

#include <trophic/habitat/habitat.hpp>
#include <trophic/habitat/nursery.hpp>
#include <trophic/population/food_web.hpp>
#include <trophic/population/individual.hpp>
#include <trophic/population/null.hpp>
#include <trophic/reproduction/genome_source/contract.hpp>

namespace trophic {

/// The origin of the next individual in a body.
struct Parentage {
  reproduction::Descent descent = reproduction::Descent::random;
  std::vector<Ancestor> parents = {};  ///< empty if the genome is random by rule or there is no individual to inherit from
  double endowment_J = 0.0;            ///< energy from the living parents; if 0, the energy comes from outside
  bool first_pays = false;             ///< whether the first of them gives all of it
  /// Those of the living parents that give energy, in equal parts.
  [[nodiscard]] std::span<const BodyIndex> payers(std::span<const BodyIndex> living) const {
    return first_pays && !living.empty() ? living.first(1) : living;
  }
};

/// The circumstances of births other than the rules: `habitat` is for tables whose bodies or gaits differ, `nursery` for those
/// that test newborns. Both must outlive the population.
struct BirthSetting {
  Null null = Null::none;
  const Habitat* habitat = nullptr;
  const Nursery* nursery = nullptr;
};

/// The species that inherits nothing in a one-sided world; empty under other nulls. Throws std::invalid_argument for a species
/// that the food web lacks, and for its only one, whose one-sided world is the shadow.
[[nodiscard]] inline OneSpecies species_of(const Null& null, const FoodWeb& web) {
  if (null.kind != Null::one_sided) return std::nullopt;
  if (web.size() < 2) {
    throw std::invalid_argument{"null = " + name_of(null) +
                                ": must be in a table with at least two species; with one species it is the shadow"};
  }
  std::string names;
  for (Species species = 0; species < web.size(); ++species) {
    if (web.name(species) == null.species) return species;
    names += (species == 0 ? "" : species + 1 < web.size() ? ", " : " or ") + name_of({Null::one_sided, web.name(species)});
  }
  throw std::invalid_argument{"null = " + name_of(null) + ": must be " + names + ", the table's species"};
}

}  // namespace trophic
