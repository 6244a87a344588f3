// SPDX-License-Identifier: MIT
// TOML values as texts.
#pragma once

#include <algorithm>
#include <sstream>
#include <trophic/params/params.hpp>
#include <trophic/params/parse_toml.hpp>

namespace trophic {

/// The shortest TOML float that reads back as the same number, bit for bit. toml++ 3.3 writes 0.1 as 0.10000000000000001, the
/// same number in a form that is hard to edit.
[[nodiscard]] inline std::string toml_float(double value) {
  const std::string text = number_text(value);
  return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

/// A value on one line, for error messages. toml++ 3.3 fails to do this: in a list with a fraction below 1 it casts a negative
/// number to an unsigned one.
[[nodiscard]] inline std::string toml_text(const toml::node& value) {
  if (const auto number = value.value_exact<double>()) return toml_float(*number);
  std::string text;
  if (const toml::array* list = value.as_array()) {
    for (const toml::node& element : *list) text.append(text.empty() ? "" : ", ").append(toml_text(element));
    return "[" + text + "]";
  }
  if (const toml::table* table = value.as_table()) {
    for (const auto& [key, element] : *table) {
      text.append(text.empty() ? "" : ", ").append(key.str()).append(" = ").append(toml_text(element));
    }
    return "{" + text + "}";
  }
  auto flags = toml::toml_formatter::default_flags & ~toml::format_flags::allow_multi_line_strings;
  const toml::value<std::string>* quoted = value.as_string();
  const auto is_control = [](char letter) { return static_cast<unsigned char>(letter) < ' '; };
  if (quoted != nullptr && std::ranges::any_of(quoted->get(), is_control)) flags &= ~toml::format_flags::allow_literal_strings;
  std::ostringstream plain;
  plain << toml::toml_formatter{value, flags};
  return plain.str();
}

}  // namespace trophic
