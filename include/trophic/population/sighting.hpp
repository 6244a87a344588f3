// SPDX-License-Identifier: MIT
// An individual's perception of its adversary.
#pragma once

#include <trophic/population/individual.hpp>

namespace trophic {

/// An individual's adversary: the closest opponent that it perceives (Sec. "Inputs").
struct Sighting {
  BodyIndex self = 0;
  BodyIndex adversary = 0;
  double distance_m = 0.0;
  double bearing_rad = 0.0;  ///< 0 ahead, positive to the right, in [-pi, pi)
  friend bool operator==(const Sighting&, const Sighting&) = default;
};

}  // namespace trophic
