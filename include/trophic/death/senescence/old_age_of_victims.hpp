// SPDX-License-Identifier: MIT
// Death at a fixed age for species that are hunted.
#pragma once

#include <trophic/death/senescence/old_age.hpp>

namespace trophic::death::senescence {

/// Rule: an individual of a species that another one eats dies iff its age >= max_age; the others never die of age. The paper
/// names the lack of ageing prey as a possible reason for their poor adaptation (Sec. "Conclusion"). The age is a free parameter.
/// Reads: own age, the food web.   Random draws: 0.
struct OldAgeOfVictims {
  static constexpr std::string_view name = "old_age_of_victims";
  static constexpr std::string_view source = "paper, Sec. \"Conclusion\": future work";

  using Params = OldAge::Params;
  Params params;

  [[nodiscard]] bool dies(const Individual& individual, const View& view, Rng&) const {
    return view.web.is_hunted(individual.species) && view.passed(individual.age_from_s, params.max_age_s);
  }
};
static_assert(Senescence<OldAgeOfVictims>);

}  // namespace trophic::death::senescence
