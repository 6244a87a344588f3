// SPDX-License-Identifier: MIT
// Pictures in memory and as PNG files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace trophic::film {

/// Rows from the top, three bytes (red, green, blue) a pixel.
struct Image {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<std::uint8_t> rgb;

  [[nodiscard]] static Image blank(std::size_t width, std::size_t height, std::uint8_t grey) {
    return {width, height, std::vector<std::uint8_t>(3 * width * height, grey)};
  }
};

/// Half as wide and high; each pixel the mean of four. The size must be even.
[[nodiscard]] Image halved(const Image& image);

/// Puts one image into another, its corner at (x, y). It must fit.
void put(Image& into, const Image& image, std::size_t x, std::size_t y);

/// Writes a new file. Throws std::runtime_error naming it when it exists or the system refuses.
void write_png(const std::filesystem::path& path, const Image& image);

}  // namespace trophic::film
