// SPDX-License-Identifier: MIT
// The blocks of a recording as bytes, and its frames as bytes and back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <trophic/support/linkage.hpp>
#include <vector>

namespace trophic::io::recording {

/// A block with its length and checksum.
[[nodiscard]] std::string block(std::string_view kind, std::string_view data);

/// zlib's levels: `small` for recordings with joints, whose runs are slow, and `fast` for those of poses only, with files a fifth
/// larger in a third of the time.
enum class Effort { fast = 3, small = 6 };

/// The bytes of the frames in a block, as in docs/recording.md. `values`: frame by frame, `columns` of them each.
[[nodiscard]] std::string packed(const std::vector<std::int16_t>& values, std::size_t columns, Effort effort = Effort::small);

/// The largest number of values in this many packed bytes: zlib expands them at most 1032 times, and a value takes two.
[[nodiscard]] constexpr std::size_t most_values(std::size_t packed_bytes) {
  return 516 * packed_bytes;
}

/// The inverse, but column by column. Throws std::invalid_argument for bytes that are not such frames.
[[nodiscard]] std::vector<std::int16_t> unpacked(std::string_view bytes, std::size_t columns, std::size_t frames);

}  // namespace trophic::io::recording

#if TROPHIC_HEADER_ONLY
#include <trophic/io/recording_planes.ipp>
#endif
