// SPDX-License-Identifier: MIT
// The origin of a newborn, and the circumstances of all births.
#pragma once

#include <trophic/habitat/habitat.hpp>
#include <trophic/habitat/nursery.hpp>
#include <trophic/population/individual.hpp>
#include <trophic/population/null.hpp>
#include <trophic/reproduction/genome_source/contract.hpp>

namespace trophic {

/// The origin of the next individual in a body.
struct Parentage {
  reproduction::Descent descent = reproduction::Descent::random;
  std::vector<Ancestor> parents = {};  ///< none if the genome is random by rule or there is no individual to inherit from
  double endowment_J = 0.0;            ///< of the living parents; if 0 the energy comes from outside
};

/// The circumstances of births besides the rules: `habitat` is for tables whose bodies or gaits differ, `nursery` for those that
/// try newborns; both outlive the population.
struct BirthSetting {
  Null null = Null::none;
  const Habitat* habitat = nullptr;
  const Nursery* nursery = nullptr;
};

}  // namespace trophic
