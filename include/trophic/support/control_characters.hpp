// SPDX-License-Identifier: MIT
// Control characters in texts that are shown in a terminal, where they must not move the cursor or set the title.
#pragma once

#include <cstddef>
#include <string_view>
#include <trophic/support/cpp20.hpp>

namespace trophic {

/// The number of bytes of the control character at the start of a text, in ASCII or U+0080 to U+009F in UTF-8; 0 if there is
/// none.
[[nodiscard]] constexpr std::size_t control_bytes(std::string_view text) {
  if (text.empty()) return 0;
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  if (byte(0) < 0x20 || byte(0) == 0x7f) return 1;
  return text.size() > 1 && byte(0) == 0xc2 && byte(1) < 0xa0 ? 2 : 0;
}

/// Whether a text has no control character.
[[nodiscard]] constexpr bool is_plain(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (control_bytes(text.substr(i)) > 0) return false;
  }
  return true;
}

}  // namespace trophic
