// SPDX-License-Identifier: MIT
// A death, while the dying individual is still in the view.
#pragma once

#include <trophic/population/individual.hpp>

namespace trophic {

/// A body whose occupant dies; it is still in the view.
struct Vacancy {
  BodyIndex body = 0;
  Cause cause = Cause::caught;
  std::optional<BodyIndex> killer = {};  ///< the body of the hunter, for Cause::caught
  std::optional<Species> successor =
      {};  ///< the species to which the body goes, if the rules fix it; a parent must be of this species
};

}  // namespace trophic
