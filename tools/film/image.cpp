// SPDX-License-Identifier: MIT
// Definitions of image.hpp.
#include <png.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tools/film/image.hpp>
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
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = PNG_FORMAT_RGB;
  std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(png), '\0');
  png_alloc_size_t size = bytes.size();
  if (png_image_write_to_memory(&png, bytes.data(), &size, 0, image.rgb.data(), 0, nullptr) == 0) {
    throw std::runtime_error{"cannot write " + path.string() + ": " + png.message};
  }
  whole.write(std::string_view{bytes}.substr(0, size));
  whole.finish();
}

}  // namespace trophic::film
