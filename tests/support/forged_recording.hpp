// SPDX-License-Identifier: MIT
// Recordings with blocks that no run wrote, and with the checksums that such blocks should have.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <trophic/io/recording_format.hpp>
#include <trophic/io/recording_planes.hpp>

namespace trophic::test {

/// A recording with the checksum that each of its blocks should have.
inline std::string with_right_checksums(const std::string& recording) {
  std::size_t at = io::recording::magic.size();
  std::string right = recording.substr(0, at);
  while (at + 12 <= recording.size()) {
    const std::size_t size = io::recording::u32_at(recording, at);
    if (size > recording.size() - at - 12) break;
    right +=
        io::recording::block(std::string_view{recording}.substr(at + 4, 4), std::string_view{recording}.substr(at + 8, size));
    at += size + 12;
  }
  return right += recording.substr(std::min(at, recording.size()));
}

/// A recording that says this of itself, and then has these blocks.
inline std::string recording_with(std::string_view head, const std::string& blocks) {
  using namespace io::recording;
  return with_right_checksums(std::string{magic} + block(head_kind, head) + blocks);
}

}  // namespace trophic::test
