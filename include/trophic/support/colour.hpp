// SPDX-License-Identifier: MIT
// Colours of pictures.
#pragma once

#include <array>
#include <cstddef>
#include <trophic/support/cpp20.hpp>

namespace trophic {

/// Red, green, blue, each in [0, 1], as displayed (sRGB).
using Colour = std::array<float, 3>;

/// Interpolates between two colours; 0 is the first.
[[nodiscard]] constexpr Colour mixed(const Colour& a, const Colour& b, float part) {
  Colour colour{};
  for (std::size_t i = 0; i < 3; ++i) colour[i] = a[i] + part * (b[i] - a[i]);
  return colour;
}

/// The colour of text and lines.
inline constexpr Colour ink{0.07F, 0.09F, 0.12F};

/// The colour of a limb for a core of this colour.
[[nodiscard]] constexpr Colour limb_colour(const Colour& core) {
  return mixed(core, ink, 0.42F);
}

}  // namespace trophic
