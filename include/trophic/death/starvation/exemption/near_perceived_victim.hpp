// SPDX-License-Identifier: MIT
// The paper's exemption: a predator close to a prey that it perceives does not starve.
#pragma once

#include <trophic/death/starvation/exemption/contract.hpp>

namespace trophic::death::starvation::exemption {

/// Rule: a hunter is exempt iff an individual that it eats and perceives with the current tags is within range (Sec.
/// "Predator Death": "at a minimum certain distance away from an observable prey"; the paper gives no range, the released code
/// uses 5 m). A prey that switches its tag ends the exemption. Reads: positions, species, visibility.   Random draws: 0.
struct NearPerceivedVictim {
  static constexpr std::string_view name = "near_perceived_victim";
  static constexpr std::string_view source = "paper, Sec. \"Predator Death\"; silent on the range: released code's";

  struct Params {
    double range_m = 5.0;
    static constexpr auto fields() {
      return std::tuple{
          field("range_m", &Params::range_m, at_least(0.0), "distance within which a perceived victim exempts the hunter")};
    }
  };
  Params params;

  [[nodiscard]] bool is_exempt(BodyIndex hunter, const View& view, const perception::Perceives& perceives) const {
    const Species own = view.robots[hunter].species;
    const auto eats = [&](Species other) { return view.web.eats(own, other); };
    const auto closest =
        view.closest(hunter, [&](BodyIndex other) { return eats(view.robots[other].species) && perceives(hunter, other); },
                     {.within_m = params.range_m, .among = view.marks(eats)});
    return closest.has_value();
  }
};
static_assert(Exemption<NearPerceivedVictim>);

}  // namespace trophic::death::starvation::exemption
