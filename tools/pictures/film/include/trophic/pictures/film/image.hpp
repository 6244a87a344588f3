// SPDX-License-Identifier: MIT
// Pictures scaled, put together and as PNG files.
#pragma once

#include <cstddef>
#include <filesystem>
#include <trophic/pictures/drawing/image.hpp>

namespace trophic::film {

using drawing::Image;

/// Half as wide and high; each pixel the mean of four. The size must be even.
[[nodiscard]] Image halved(const Image& image);

/// Puts one image into another, its corner at (x, y). It must fit.
void put(Image& into, const Image& image, std::size_t x, std::size_t y);

/// Writes a new file. Throws std::runtime_error naming it when it exists or the system refuses.
void write_png(const std::filesystem::path& path, const Image& image);

}  // namespace trophic::film
