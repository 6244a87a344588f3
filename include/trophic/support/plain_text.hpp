// SPDX-License-Identifier: MIT
// Texts of JSON files that are shown in a terminal.
#pragma once

#include <trophic/support/control_characters.hpp>
#include <trophic/support/json.hpp>

namespace trophic {

/// Returns the text at a key. Throws Json::exception if the key is missing or is not a text, std::invalid_argument if the text
/// has a control character.
[[nodiscard]] inline std::string plain_text(const Json& object, const char* key) {
  std::string text = object.at(key).get<std::string>();
  if (!is_plain(text))
    throw std::invalid_argument{std::string{key} + " = " + json_text(text) + ": must be text without control characters"};
  return text;
}

/// A text to be quoted in a message: its beginning, if it is long.
[[nodiscard]] inline std::string excerpt(std::string_view text) {
  constexpr std::size_t most_bytes = 100;
  return std::string{text.substr(0, most_bytes)} + (text.size() > most_bytes ? "..." : "");
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
