// SPDX-License-Identifier: MIT
// Nobody is given up for a species that dies out.
#pragma once

#include <string_view>
#include <trophic/death/rescue/contract.hpp>
#include <vector>

namespace trophic::death::rescue {

/// Rule: nobody is sacrificed, so that hunters may die out.   Reads: nothing.   Random draws: 0.
struct NoRescue {
  static constexpr std::string_view name = "no_rescue";
  static constexpr std::string_view source = "control";
  [[nodiscard]] std::vector<Sacrifice> sacrifices(const View&, Rng&) const { return {}; }
};
static_assert(Rescue<NoRescue>);

}  // namespace trophic::death::rescue
