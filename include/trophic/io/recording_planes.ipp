// SPDX-License-Identifier: MIT
// Definitions of recording_planes.hpp.
#pragma once

#include <zlib.h>

#include <stdexcept>
#include <trophic/io/recording_format.hpp>
#include <trophic/io/recording_planes.hpp>
#include <trophic/support/checksum.hpp>

namespace trophic::io::recording {

TROPHIC_INLINE std::string block(std::string_view kind, std::string_view data) {
  std::string bytes;
  append_u32(bytes, static_cast<std::uint32_t>(data.size()));
  bytes.append(kind).append(data);
  append_u32(bytes, checksum(std::string_view{bytes}.substr(4)));
  return bytes;
}

TROPHIC_INLINE std::string packed(const std::vector<std::int16_t>& values, std::size_t columns, Effort effort) {
  const std::size_t frames = values.size() / columns;
  std::string planes(2 * values.size(), '\0');
  std::size_t at = 0;
  for (std::size_t column = 0; column < columns; ++column) {
    std::uint16_t before = 0;
    for (std::size_t frame = 0; frame < frames; ++frame, ++at) {
      const auto now = static_cast<std::uint16_t>(values[frame * columns + column]);
      const std::uint16_t difference = folded(static_cast<std::uint16_t>(now - before));
      planes[at] = static_cast<char>(difference & 0xFFU);
      planes[values.size() + at] = static_cast<char>(difference >> 8U);
      before = now;
    }
  }
  uLongf size = compressBound(static_cast<uLong>(planes.size()));
  std::string bytes(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(bytes.data()), &size, reinterpret_cast<const Bytef*>(planes.data()),
                static_cast<uLong>(planes.size()), static_cast<int>(effort)) != Z_OK) {
    throw std::runtime_error{"zlib cannot compress a block of a recording: out of memory"};
  }
  bytes.resize(size);
  return bytes;
}

TROPHIC_INLINE std::vector<std::int16_t> unpacked(std::string_view bytes, std::size_t columns, std::size_t frames) {
  const std::size_t count = columns * frames;
  std::vector<unsigned char> planes(2 * count);
  auto size = static_cast<uLongf>(planes.size());
  const int done =
      uncompress(planes.data(), &size, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uLong>(bytes.size()));
  if (done != Z_OK || size != planes.size()) throw std::invalid_argument{"damaged frames of a recording"};
  std::vector<std::int16_t> values(count);
  for (std::size_t column = 0; column < columns; ++column) {
    std::uint16_t now = 0;
    for (std::size_t frame = 0; frame < frames; ++frame) {
      const std::size_t at = column * frames + frame;
      const auto folded = static_cast<std::uint16_t>(planes[at] + 256U * planes[count + at]);
      now = static_cast<std::uint16_t>(now + unfolded(folded));
      values[at] = static_cast<std::int16_t>(now);
    }
  }
  return values;
}

}  // namespace trophic::io::recording
