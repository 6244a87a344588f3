// SPDX-License-Identifier: MIT
// Definitions of image.hpp.
#include <png.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>
#include <trophic/pictures/film/image.hpp>
#include <trophic/support/new_file.hpp>

namespace trophic::film {

Image halved(const Image& image) {
  Image half = Image::blank(image.width / 2, image.height / 2, 0);
  for (std::size_t y = 0; y < half.height; ++y) {
    const std::uint8_t* above = image.rgb.data() + 6 * y * image.width;
    const std::uint8_t* below = above + 3 * image.width;
    std::uint8_t* out = half.rgb.data() + 3 * y * half.width;
    for (std::size_t x = 0; x < half.width; ++x) {
      for (std::size_t c = 0; c < 3; ++c) {
        const std::size_t at = 6 * x + c;
        out[3 * x + c] = static_cast<std::uint8_t>((above[at] + above[at + 3] + below[at] + below[at + 3] + 2) / 4);
      }
    }
  }
  return half;
}

void put(Image& into, const Image& image, std::size_t x, std::size_t y) {
  for (std::size_t row = 0; row < image.height; ++row) {
    std::copy_n(image.rgb.begin() + static_cast<std::ptrdiff_t>(3 * row * image.width), 3 * image.width,
                into.rgb.begin() + static_cast<std::ptrdiff_t>(3 * ((y + row) * into.width + x)));
  }
}

void write_png(const std::filesystem::path& path, const Image& image) {
  NewFile whole{path};
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file{std::fopen(whole.part().c_str(), "wb"), &std::fclose};
  if (!file) throw std::runtime_error{"cannot create " + path.string() + ": " + std::strerror(errno)};
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = PNG_FORMAT_RGB;
  const bool written = png_image_write_to_stdio(&png, file.get(), 0, image.rgb.data(), 0, nullptr) != 0;
  if (!written || std::fflush(file.get()) != 0) {
    throw std::runtime_error{"cannot write " + path.string() + ": " + (written ? std::strerror(errno) : png.message)};
  }
  whole.finish();
}

}  // namespace trophic::film
