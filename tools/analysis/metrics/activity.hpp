// SPDX-License-Identifier: MIT
// Evolutionary activity of types, compared type by type with what drift gives them.
#pragma once

#include <span>
#include <tools/reading/lineages.hpp>
#include <tools/reading/signatures.hpp>
#include <vector>

namespace trophic::analysis {

/// The types that are present at each of a series of times, each once, ascending.
using Presence = std::vector<std::vector<Type>>;

[[nodiscard]] Presence presence_of(const Forest& forest, Species species, std::span<const Type> types,
                                   std::span<const double> times_s);

/// Activity at a time [bedau1998]. The activity of a type is the number of times, up to this one, at which it was present.
struct Activity {
  double diversity = 0.0;  ///< D: types present
  double mean = 0.0;       ///< activity of the types present, mean over these
  double excess = 0.0;     ///< the same of what each type's activity exceeds its own mean activity in the nulls by, or 0
  double fresh = 0.0;      ///< types whose activity first exceeds what 95 % of the types of the nulls ever reach
};

/// @param nulls presences at the same times in forests of which nothing was selected; at least one.
[[nodiscard]] std::vector<Activity> activity_of(const Presence& presence, std::span<const Presence> nulls);

}  // namespace trophic::analysis
