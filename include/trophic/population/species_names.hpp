// SPDX-License-Identifier: MIT
// The names of a community's species, as names of a group of parameters.
#pragma once

#include <trophic/support/cpp20.hpp>

namespace trophic::detail {

template <class Community>
struct SpeciesNames {
  static constexpr const auto& names = Community::species_names;
};

}  // namespace trophic::detail
