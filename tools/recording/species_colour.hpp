// SPDX-License-Identifier: MIT
// The colours of species in films, replays and saved worlds.
#pragma once

#include <array>
#include <span>
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

/// The colour of a floor with the most of a food: green, purple, yellow in the order of foods; they repeat after the last.
[[nodiscard]] constexpr Colour food_colour(std::size_t food) {
  constexpr std::array<Colour, 3> colours{{{0.61F, 0.77F, 0.5F}, {0.78F, 0.63F, 0.86F}, {0.93F, 0.8F, 0.42F}}};
  return colours[food % colours.size()];
}
/// The colour of a floor with these foods, as parts of the most: each food filters the light of the floor.
[[nodiscard]] constexpr Colour floor_with(const Colour& floor, std::span<const float> foods) {
  Colour colour = floor;
  for (std::size_t food = 0; food < foods.size(); ++food) {
    for (std::size_t i = 0; i < 3; ++i) colour[i] *= 1.0F - foods[food] * (1.0F - food_colour(food)[i] / floor[i]);
  }
  return colour;
}

}  // namespace trophic
