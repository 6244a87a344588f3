// SPDX-License-Identifier: MIT
// Definitions of json.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <trophic/support/json.hpp>

namespace trophic {

namespace detail {

/// Returns the text up to the first bracket that is nested too deep or key that is one too many, which is then not JSON. The
/// library copies and destroys nested values by recursion, and compares a key with each one before it.
[[nodiscard]] TROPHIC_INLINE std::string_view within_bounds(std::string_view text) {
  constexpr std::size_t most_depth = 64;
  constexpr std::size_t most_keys = 10000;
  std::array<std::size_t, most_depth + 1> keys{};
  std::size_t depth = 0;
  bool in_text = false;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (in_text && c == '\\') {
      ++at;
    } else if (c == '"') {
      in_text = !in_text;
    } else if (!in_text && (c == '[' || c == '{')) {
      if (++depth > most_depth) return text.substr(0, at);
      keys[depth] = 0;
    } else if (!in_text && c == ':') {
      if (++keys[depth] > most_keys) return text.substr(0, at);
    } else if (!in_text && (c == ']' || c == '}') && depth > 0) {
      --depth;
    }
  }
  return text;
}

}  // namespace detail

TROPHIC_INLINE Json parse_json(std::string_view text) {
  return Json::parse(detail::within_bounds(text));
}

TROPHIC_INLINE Json parse_json_or_null(std::string_view text) {
  Json json = Json::parse(detail::within_bounds(text), nullptr, false);
  if (json.is_discarded()) json = nullptr;
  return json;
}

TROPHIC_INLINE std::string json_text(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace trophic
