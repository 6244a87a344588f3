// SPDX-License-Identifier: MIT
// Texts from files that are shown in a terminal: none may move its cursor or set its title.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <trophic/support/json.hpp>

namespace trophic {

/// How many bytes of a text, from its first, are one control character: of ASCII, or U+0080 to U+009F in UTF-8; 0 if it begins
/// with none.
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

/// Returns the text at a key. Throws Json::exception if the key is missing or is not a text, std::invalid_argument if the text
/// has a control character.
[[nodiscard]] inline std::string plain_text(const Json& object, const char* key) {
  std::string text = object.at(key).get<std::string>();
  if (!is_plain(text))
    throw std::invalid_argument{std::string{key} + " = " + json_text(text) + ": must be text without control characters"};
  return text;
}

/// Throws std::invalid_argument if a key or a text in a value has a control character.
inline void check_plain(const Json& value) {
  const auto check = [](const std::string& text) {
    if (!is_plain(text)) throw std::invalid_argument{json_text(text) + ": must be text without control characters"};
  };
  if (value.is_string()) check(value.get_ref<const std::string&>());
  if (!value.is_structured()) return;
  for (const auto& [key, inner] : value.items()) {
    check(key);
    check_plain(inner);
  }
}

}  // namespace trophic
