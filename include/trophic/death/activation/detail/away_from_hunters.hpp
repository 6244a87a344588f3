// SPDX-License-Identifier: MIT
// Whether a newborn is out of its hunters' way: what two activations share.
#pragma once

#include <trophic/params/params.hpp>
#include <trophic/population/view.hpp>
#include <tuple>

namespace trophic::death::activation::detail {

struct SafeDistance {
  double distance_m = 5.0;
  static constexpr auto fields() {
    return std::tuple{field("distance_m", &SafeDistance::distance_m, at_least(0.0), "farther than this from every hunter")};
  }
};

/// Whether the closest individual that eats the species in `body`, whatever the tags, is farther away than the distance.
[[nodiscard]] inline bool away_from_hunters(const SafeDistance& safe, BodyIndex body, const View& view) {
  const Species own = view.robots[body].species;
  const auto hunter = view.closest(body, [&](const Individual& other) { return view.web.eats(other.species, own); });
  return !hunter || view.distance_m(body, *hunter) > safe.distance_m;
}

}  // namespace trophic::death::activation::detail
