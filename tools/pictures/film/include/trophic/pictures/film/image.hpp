// SPDX-License-Identifier: MIT
// Scales and combines pictures, and writes them as PNG files.
#pragma once

#include <cstddef>
#include <filesystem>
#include <trophic/pictures/drawing/image.hpp>

namespace trophic::film {

using drawing::Image;

/// Returns the picture at half its width and height; each pixel is the mean of four. The size must be even.
[[nodiscard]] Image halved(const Image& image);

/// Copies one image into another, its corner at (x, y). It must fit.
void put(Image& into, const Image& image, std::size_t x, std::size_t y);

/// Writes a new file. Throws std::runtime_error naming it if it exists or cannot be written.
void write_png(const std::filesystem::path& path, const Image& image);

}  // namespace trophic::film
