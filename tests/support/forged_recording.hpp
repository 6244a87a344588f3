// SPDX-License-Identifier: MIT
// Recordings with blocks that no run wrote, and with the checksums that such blocks should have.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <trophic/observe/recording_format.hpp>
#include <trophic/support/checksum.hpp>

namespace trophic::test {

/// A block of a recording.
inline std::string recorded_block(std::string_view kind, std::string_view data) {
  using observe::recording::append_u32;
  std::string block;
  append_u32(block, static_cast<std::uint32_t>(data.size()));
  block.append(kind).append(data);
  append_u32(block, checksum(std::string_view{block}.substr(4)));
  return block;
}

/// A recording with the checksum that each of its blocks should have.
inline std::string with_right_checksums(const std::string& recording) {
  std::size_t at = observe::recording::magic.size();
  std::string right = recording.substr(0, at);
  while (at + 12 <= recording.size()) {
    const std::size_t size = observe::recording::u32_at(recording, at);
    if (size > recording.size() - at - 12) break;
    right += recorded_block(std::string_view{recording}.substr(at + 4, 4), std::string_view{recording}.substr(at + 8, size));
    at += size + 12;
  }
  return right += recording.substr(std::min(at, recording.size()));
}

/// A recording that says this of itself, and then has these blocks.
inline std::string recording_with(std::string_view head, const std::string& blocks) {
  return std::string{observe::recording::magic} + recorded_block(observe::recording::head_kind, head) +
         with_right_checksums(std::string{observe::recording::magic} + blocks).substr(observe::recording::magic.size());
}

}  // namespace trophic::test
