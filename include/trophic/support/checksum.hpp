// SPDX-License-Identifier: MIT
// The checksum of tables, recordings and checkpoints.
#pragma once

#include <cstdint>
#include <string_view>
#include <trophic/support/linkage.hpp>

namespace trophic {

/// CRC-32 as in zlib, PNG and Python's zlib.crc32. `before` is the checksum of the preceding bytes, if any.
[[nodiscard]] std::uint32_t checksum(std::string_view bytes, std::uint32_t before = 0);

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/support/checksum.ipp>
#endif
