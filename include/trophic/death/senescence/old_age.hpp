// SPDX-License-Identifier: MIT
// Death at a fixed age.
#pragma once

#include <trophic/death/senescence/contract.hpp>

namespace trophic::death::senescence {

/// Rule: an individual dies iff its age >= max_age. The paper names the lack of an aging process as a possible reason for
/// the prey's poor adaptation (Sec. "Conclusion"). Reads: own age.   Random draws: 0.
struct OldAge {
  static constexpr std::string_view name = "old_age";
  static constexpr std::string_view source = "paper, Sec. \"Conclusion\": future work";

  struct Params {
    double max_age_s = 600.0;
    static constexpr auto fields() { return std::tuple{field("max_age_s", &Params::max_age_s, above(0.0), "age at death")}; }
  };
  Params params;

  [[nodiscard]] bool dies(const Individual& individual, const View& view, Rng&) const {
    return view.passed(individual.age_from_s, params.max_age_s);
  }
};
static_assert(Senescence<OldAge>);

}  // namespace trophic::death::senescence
