// SPDX-License-Identifier: MIT
// Definitions of json.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <trophic/support/checksum.hpp>
#include <trophic/support/json.hpp>

namespace trophic {

namespace detail {

/// JSON that is refused, with the bound that it exceeds.
class ExcessiveJson : public Json::exception {
 public:
  explicit ExcessiveJson(const char* what) : exception{0, what} {}
};

/// The text before the checksum of a sealed text.
inline constexpr std::string_view before_sum = ",\n  \"crc32\": ";

/// A text with this beginning, and its checksum.
[[nodiscard]] inline std::string sealed(std::string_view beginning) {
  return std::string{beginning} + std::string{before_sum} + std::to_string(checksum(beginning)) + "\n}\n";
}

/// Returns how a text exceeds a bound, or null. The library copies and destroys nested values by recursion, and compares a key
/// with each one before it.
[[nodiscard]] inline const char* excess_of(std::string_view text) {
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
      if (++depth > most_depth) return "is JSON nested more than 64 levels deep, which is refused";
      keys[depth] = 0;
    } else if (!in_text && c == ':') {
      if (++keys[depth] > most_keys) return "is JSON with more than 10000 keys in an object, which is refused";
    } else if (!in_text && (c == ']' || c == '}') && depth > 0) {
      --depth;
    }
  }
  return nullptr;
}

}  // namespace detail

TROPHIC_INLINE Json parse_json(std::string_view text) {
  if (const char* const excess = detail::excess_of(text)) throw detail::ExcessiveJson{excess};
  return Json::parse(text);
}

TROPHIC_INLINE Json parse_json_or_null(std::string_view text) {
  if (detail::excess_of(text) != nullptr) return nullptr;
  Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) json = nullptr;
  return json;
}

TROPHIC_INLINE std::string sealed_text(const Json& object) {
  const std::string text = json_text(object, 2);
  return detail::sealed(std::string_view{text}.substr(0, text.size() - 2));
}

TROPHIC_INLINE Json parse_sealed(std::string_view text) {
  Json json = parse_json_or_null(text);
  if (!json.is_object()) return nullptr;
  if (!json.contains("format") && !json.contains("crc32")) return json;
  const std::size_t end = text.rfind(detail::before_sum);
  if (end == std::string_view::npos || text != detail::sealed(text.substr(0, end))) json = nullptr;
  return json;
}

TROPHIC_INLINE std::string json_text(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace trophic
