// SPDX-License-Identifier: MIT
// No individual dies of natural causes.
#pragma once

#include <trophic/death/senescence/contract.hpp>

namespace trophic::death::senescence {

/// Rule: individuals die only when caught, starved or sacrificed, as in the paper.   Reads: nothing.   Random draws: 0.
struct NoSenescence {
  static constexpr std::string_view name = "no_senescence";
  static constexpr std::string_view source = "paper: no such rule";
  [[nodiscard]] bool dies(const Individual&, const View&, Rng&) const { return false; }
};
static_assert(Senescence<NoSenescence>);

}  // namespace trophic::death::senescence
