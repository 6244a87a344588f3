// SPDX-License-Identifier: MIT
// Pictures in memory: scaled, combined and written as PNG files.
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

/// Returns the picture at half its width and height; each pixel is the mean of four. The size must be even.
[[nodiscard]] Image halved(const Image& image);

/// Copies one image into another, its corner at (x, y). It must fit.
void put(Image& into, const Image& image, std::size_t x, std::size_t y);

/// Writes a new file. Throws std::runtime_error naming it if it exists or cannot be written.
void write_png(const std::filesystem::path& path, const Image& image);

}  // namespace trophic::film
