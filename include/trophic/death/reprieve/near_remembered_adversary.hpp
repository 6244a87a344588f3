// SPDX-License-Identifier: MIT
// The released code's reprieve: by the last stored distance, however stale.
#pragma once

#include <string_view>
#include <trophic/death/reprieve/contract.hpp>
#include <trophic/params/params.hpp>
#include <tuple>

namespace trophic::death::reprieve {

/// Rule (released code): spared iff the adversary distance stored in the hunter's body is below range. It is stored only
/// while an adversary is perceived, starts at 0 and outlives births in that body, so that a hunter whose prey has just
/// hidden stays exempt: the opposite of the text. Reads: body memory.   Random draws: 0.
struct NearRememberedAdversary {
  static constexpr std::string_view name = "near_remembered_adversary";
  static constexpr std::string_view source = "released code";

  struct Params {
    double range_m = 5.0;
    static constexpr auto fields() {
      return std::tuple{field("range_m", &Params::range_m, at_least(0.0), "a stored distance below this spares the hunter")};
    }
  };
  Params params;

  [[nodiscard]] bool spared(BodyIndex hunter, const View& view) const {
    return view.robots[hunter].memory.adversary_distance_m < params.range_m;
  }
};
static_assert(Reprieve<NearRememberedAdversary>);

}  // namespace trophic::death::reprieve
