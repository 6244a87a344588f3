// SPDX-License-Identifier: MIT
// Reports a floor that no hunted species exceeds at the start; the floors share this.
#pragma once

#include <string>
#include <trophic/population/outset.hpp>

namespace trophic::death::floor::detail {

/// The hunted species that no catch or sacrifice may reduce at the start (Outset).
[[nodiscard]] inline std::string spares_all(std::size_t floor, const Outset& outset) {
  std::string text;
  for (Species species = 0; species < outset.web.size(); ++species) {
    if (!outset.web.is_hunted(species) || outset.founders[species] > floor) continue;
    text += (text.empty() ? "floor = " + std::to_string(floor) + ": no catch or sacrifice of " : ", or of ") +
            outset.web.name(species) + ", because the run starts with " + std::to_string(outset.founders[species]);
  }
  return text;
}

}  // namespace trophic::death::floor::detail
