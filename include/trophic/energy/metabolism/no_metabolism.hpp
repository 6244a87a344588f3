// SPDX-License-Identifier: MIT
// Individuals have no energy.
#pragma once

#include <trophic/energy/metabolism/contract.hpp>

namespace trophic::energy::metabolism {

/// Rule: individuals have, spend and need no energy (the paper's predators count ticks, Sec. "Predator Death").   Reads: nothing.
/// Random draws: 0.
struct NoMetabolism {
  static constexpr std::string_view name = "no_metabolism";
  static constexpr std::string_view source = "paper: no such rule";
  [[nodiscard]] double first_J(const Individual&, Rng&) const { return 0.0; }
  [[nodiscard]] double upkeep_J(BodyIndex, double, const View&) const { return 0.0; }
  [[nodiscard]] double bite_J(BodyIndex, std::size_t, double, const View&) const { return 0.0; }
  [[nodiscard]] double meal_J(BodyIndex, BodyIndex, const View&) const { return 0.0; }
  [[nodiscard]] bool starves(BodyIndex, const View&) const { return false; }
};
static_assert(Metabolism<NoMetabolism>);

}  // namespace trophic::energy::metabolism
