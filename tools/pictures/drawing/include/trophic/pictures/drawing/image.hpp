// SPDX-License-Identifier: MIT
// Pictures in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace trophic::drawing {

/// Rows from the top, three bytes (red, green, blue) a pixel.
struct Image {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<std::uint8_t> rgb;

  [[nodiscard]] static Image blank(std::size_t width, std::size_t height, std::uint8_t grey) {
    return {width, height, std::vector<std::uint8_t>(3 * width * height, grey)};
  }
};

}  // namespace trophic::drawing
