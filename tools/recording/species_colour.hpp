// SPDX-License-Identifier: MIT
// The colours of species in films, replays and saved worlds.
#pragma once

#include <array>
#include <trophic/population/food_web.hpp>
#include <trophic/support/colour.hpp>

namespace trophic {

/// Okabe and Ito's colours, which colour-blind readers can distinguish, in the order of species; they repeat after the last.
[[nodiscard]] constexpr Colour species_colour(Species species) {
  constexpr std::array<std::array<float, 3>, 7> colours{
      {{0, 114, 178}, {213, 94, 0}, {0, 158, 115}, {204, 121, 167}, {230, 159, 0}, {86, 180, 233}, {122, 92, 0}}};
  const auto& c = colours[species % colours.size()];
  return {c[0] / 255.0F, c[1] / 255.0F, c[2] / 255.0F};
}

/// The colour of a newborn that hunters neither perceive nor catch yet.
inline constexpr Colour inactive_colour{0.6F, 0.63F, 0.66F};
inline constexpr Colour food_colour{0.61F, 0.77F, 0.5F};  ///< of a floor with the most food

}  // namespace trophic
