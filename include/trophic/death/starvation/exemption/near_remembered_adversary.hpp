// SPDX-License-Identifier: MIT
// The released code's exemption, based on the last stored distance, however old it is.
#pragma once

#include <trophic/death/starvation/exemption/contract.hpp>

namespace trophic::death::starvation::exemption {

/// Rule (released code): exempt iff the adversary distance stored in the hunter's body is below range. It is stored only while
/// an adversary is perceived, starts at 0 and outlives births in that body, so a hunter whose prey has just hidden stays exempt,
/// contrary to the text. Reads: its own state.   Random draws: 0.
struct NearRememberedAdversary {
  static constexpr std::string_view name = "near_remembered_adversary";
  static constexpr std::string_view source = "released code";

  struct Params {
    double range_m = 5.0;
    static constexpr auto fields() {
      return std::tuple{field("range_m", &Params::range_m, at_least(0.0), "stored distance below which the hunter is exempt")};
    }
  };
  Params params;

  /// The state of a body.
  struct State {
    double adversary_distance_m = 0.0;  ///< distance to the adversary when one was last perceived; 0 before the first
    static constexpr auto fields() { return std::tuple{field("adversary_distance_m", &State::adversary_distance_m)}; }
  };
  [[nodiscard]] State born(const Individual&, const State*, const State& body) const { return body; }
  void on_sighting(State& own, BodyIndex, const std::optional<Sighting>& sighting, const View&) const {
    if (sighting) own.adversary_distance_m = sighting->distance_m;
  }

  [[nodiscard]] bool is_exempt(BodyIndex, const View&, const perception::Perceives&, const State& own) const {
    return own.adversary_distance_m < params.range_m;
  }
};
static_assert(Exemption<NearRememberedAdversary>);

}  // namespace trophic::death::starvation::exemption
