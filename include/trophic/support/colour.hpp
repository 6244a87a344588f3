// SPDX-License-Identifier: MIT
// Colours of pictures.
#pragma once

#include <array>
#include <cstddef>

namespace trophic {

/// Red, green, blue, each in [0, 1], as screens take them (sRGB).
using Colour = std::array<float, 3>;

/// A part of the way from one colour to another; 0 is the first.
[[nodiscard]] constexpr Colour mixed(const Colour& a, const Colour& b, float part) {
  Colour colour{};
  for (std::size_t i = 0; i < 3; ++i) colour[i] = a[i] + part * (b[i] - a[i]);
  return colour;
}

/// What pictures write and draw lines in.
inline constexpr Colour ink{0.07F, 0.09F, 0.12F};

/// A limb beside a core of that colour.
[[nodiscard]] constexpr Colour limb_colour(const Colour& core) {
  return mixed(core, ink, 0.42F);
}

}  // namespace trophic
