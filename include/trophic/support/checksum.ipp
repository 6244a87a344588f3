// SPDX-License-Identifier: MIT
// Definitions of checksum.hpp.
#pragma once

#include <zlib.h>

#include <trophic/support/checksum.hpp>

namespace trophic {

TROPHIC_INLINE std::uint32_t checksum(std::string_view bytes, std::uint32_t before) {
  return static_cast<std::uint32_t>(crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

}  // namespace trophic
