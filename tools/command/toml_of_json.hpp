// SPDX-License-Identifier: MIT
// Converts numbers, texts and switches in JSON to those of a configuration file.
#pragma once

#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tools/command/read_parameters.hpp>

namespace trophic::command {

/// The largest whole number in TOML; a larger one becomes a floating-point number, which cannot be read as a whole number.
inline constexpr std::uint64_t most_whole = std::numeric_limits<std::int64_t>::max();

/// Puts a value into a table under a key. Throws Json::exception for a value that is not a number, text or switch.
template <class Json>
void insert_value(toml::table& table, std::string_view key, const Json& value) {
  if (value.is_boolean()) {
    table.insert(key, value.template get<bool>());
  } else if (value.is_number_integer() && !(value.is_number_unsigned() && value.template get<std::uint64_t>() > most_whole)) {
    table.insert(key, value.template get<std::int64_t>());
  } else if (value.is_number()) {
    table.insert(key, value.template get<double>());
  } else {
    table.insert(key, value.template get<std::string>());
  }
}

/// Inserts a value under its path into nested tables. Throws std::invalid_argument for a path below a value.
template <class Json>
void insert_at(toml::table& table, std::string_view path, const Json& value) {
  const std::size_t dot = path.find('.');
  if (dot == std::string_view::npos) return insert_value(table, path, value);
  toml::node* nested = &table.insert(path.substr(0, dot), toml::table{}).first->second;
  if (!nested->is_table()) throw std::invalid_argument{std::string{path} + ": is nested under a key that has a value"};
  insert_at(*nested->as_table(), path.substr(dot + 1), value);
}

/// The parameters of a manifest in the form of a configuration file. Throws Json::exception for a value that is not a number,
/// text or switch.
template <class Json>
[[nodiscard]] toml::table toml_of(const Json& json) {
  toml::table table;
  for (const auto& [key, value] : json.items()) {
    if (value.is_object()) {
      table.insert(key, toml_of(value));
    } else {
      insert_value(table, key, value);
    }
  }
  return table;
}

}  // namespace trophic::command
