// SPDX-License-Identifier: MIT
// Reads and writes JSON in one place, so that the templates of nlohmann-json are compiled once.
#pragma once

#include <concepts>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <trophic/support/linkage.hpp>
#include <utility>

namespace trophic {

/// Objects keep the order of their keys, in files as in memory.
using Json = nlohmann::ordered_json;

/// Parses a text. Throws Json::exception if it is not JSON, if brackets are nested more than 64 deep or if
/// an object has more than 10,000 keys.
[[nodiscard]] Json parse_json(std::string_view text);

/// Parses a text; returns null if it is not JSON.
[[nodiscard]] Json parse_json_or_null(std::string_view text);

/// Writes text on one line or, with an indent >= 0, one value per line. Bytes that are not UTF-8, for example in the name of a
/// folder, become U+FFFD.
[[nodiscard]] std::string json_text(const Json& json, int indent = -1);

/// Writes an object as text, one value per line, whose last entry "crc32" is the CRC-32 of the text before it.
[[nodiscard]] std::string sealed_text(const Json& object);

/// Parses a text of sealed_text. Returns null if it is not an object or was modified since. An object without "format" and
/// "crc32" is from an older program and is accepted unchecked.
[[nodiscard]] Json parse_sealed(std::string_view text);

/// Returns the message of an exception of the library, without its number.
[[nodiscard]] inline std::string reason_of(const Json::exception& error) {
  const std::string_view text = error.what();  // "[json.exception.out_of_range.403] key 'seed' not found"
  return std::string{text.substr(text.starts_with("[json.") ? text.find(' ') + 1 : 0)};
}

/// The whole number at a key; a plain `get` would also convert -1 and 1e300. Throws Json::exception if the key is missing,
/// std::invalid_argument "KEY = VALUE: must be a whole number from LEAST to MOST".
template <std::integral Number>
[[nodiscard]] Number whole_number(const Json& object, const std::string& key,
                                  Number least = std::numeric_limits<Number>::lowest(),
                                  Number most = std::numeric_limits<Number>::max()) {
  const Json& value = object.at(key);
  const auto fits = [&](auto number) { return std::cmp_greater_equal(number, least) && std::cmp_less_equal(number, most); };
  const bool good = value.is_number_unsigned() ? fits(value.get<std::uint64_t>())
                                               : value.is_number_integer() && fits(value.get<std::int64_t>());
  if (good) return value.get<Number>();
  throw std::invalid_argument{key + " = " + json_text(value) + ": must be a whole number from " + std::to_string(least) + " to " +
                              std::to_string(most)};
}

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/support/json.ipp>
#endif
