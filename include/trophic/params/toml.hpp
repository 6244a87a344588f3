// SPDX-License-Identifier: MIT
// Reads numbers from TOML files and from "path=value" texts into any Params; unknown keys are errors.
#pragma once

#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <trophic/params/params.hpp>
#include <trophic/params/parse_toml.hpp>
#include <trophic/params/toml_text.hpp>
#include <type_traits>
#include <utility>

namespace trophic {

namespace detail {

[[noreturn]] inline void reject(const std::string& path, const toml::node& node, std::string_view must) {
  throw std::invalid_argument{path + " = " + toml_text(node) + ": must be " + std::string{must}};
}

template <class T>
void read_value(T& target, const toml::node& node, const std::string& path) {
  if constexpr (std::same_as<T, bool>) {
    const auto value = node.value_exact<bool>();
    if (!value) reject(path, node, "true or false");
    target = *value;
  } else if constexpr (std::integral<T>) {
    const auto value = node.value_exact<std::int64_t>();
    if (!value) reject(path, node, "a whole number");
    if (std::cmp_less(*value, std::numeric_limits<T>::lowest())) {
      reject(path, node, ">= " + number_text(std::numeric_limits<T>::lowest()));
    }
    if (std::cmp_greater(*value, std::numeric_limits<T>::max())) {
      reject(path, node, "<= " + number_text(std::numeric_limits<T>::max()));
    }
    target = static_cast<T>(*value);
  } else if constexpr (std::floating_point<T>) {
    if (!node.is_number()) reject(path, node, "a number");
    const auto value = node.value<double>();
    if (!value) reject(path, node, "from -2^53 to 2^53, or have a decimal point");
    target = *value;
  } else if constexpr (NamedEnum<T>) {
    const auto name = node.value_exact<std::string>();
    std::string choices;
    std::size_t index = 0;
    for (const std::string_view choice : enum_names(T{})) {
      if (name && *name == choice) {
        target = static_cast<T>(index);
        return;
      }
      choices += (index++ == 0 ? "" : " or ") + std::string{choice};
    }
    reject(path, node, choices);
  } else {
    const auto value = node.value_exact<std::string>();
    if (!value) reject(path, node, "a text");
    target = *value;
  }
}

template <class P>
void read_table(P& params, const toml::table& table, const std::string& prefix);

/// Reads the numbers of a table itself; `path` is the path of the table, for errors.
template <class T>
concept ReadsNumbers = requires(T& value, const toml::table& table, const std::string& path) {
  value.read_numbers(table, path);
};

/// Sets the field with the name `key`.
struct ReadField {
  std::string_view key;
  const toml::node& node;
  const std::string& path;
  bool known = false;
  std::string keys = {};  ///< of all fields

  template <class T>
  void operator()(const FieldText& f, T& value) {
    keys += (keys.empty() ? "" : ", ") + std::string{f.name};
    if (f.name != key) return;
    known = true;
    if constexpr (ReadsNumbers<T>) {
      if (!node.is_table()) reject(path, node, "a table of numbers");
      value.read_numbers(*node.as_table(), path);
    } else if constexpr (HasFields<T> || (std::is_empty_v<T> && !std::is_enum_v<T>)) {
      if (!node.is_table()) reject(path, node, "a table of numbers");
      read_table(value, *node.as_table(), path);
    } else {
      read_value(value, node, path);
    }
  }
};

template <class P>
void read_table(P& params, const toml::table& table, const std::string& prefix) {
  for (const auto& entry : table) {
    const std::string path = join_path(prefix, entry.first.str());
    ReadField read{.key = entry.first.str(), .node = entry.second, .path = path};
    for_each_field(params, read);
    if (!read.known) {
      throw std::invalid_argument{path + ": unknown key; " +
                                  (read.keys.empty() ? "this rule has no numbers" : "known here: " + read.keys)};
    }
  }
}

}  // namespace detail

/// Sets the fields that a table names. Throws std::invalid_argument "PATH: unknown key ..." or "PATH = VALUE: must be ...".
/// Bounds are checked by `validate`, not here.
template <class P>
void read_numbers(P& params, const toml::table& table) {
  detail::read_table(params, table, "");
}

/// Removes the choice under `key` from a configuration file and returns it. Throws std::invalid_argument if it is not a text.
[[nodiscard]] inline std::optional<std::string> take_choice(toml::table& table, std::string_view key) {
  const toml::node* node = table.get(key);
  if (node == nullptr) return std::nullopt;
  const auto name = node->value_exact<std::string>();
  if (!name) throw std::invalid_argument{std::string{key} + ": must be a text"};
  table.erase(key);
  return name;
}

/// Returns the table of an assignment such as "rules.mutation.sd=0.1". A value that is not a TOML value is read as text:
/// "ecology.robot=gecko". Throws std::invalid_argument if the text is not an assignment.
[[nodiscard]] inline toml::table read_assignment(std::string_view assignment) {
  const auto equals = assignment.find('=');
  const auto bad = [&] {
    const std::string said = assignment.size() <= 80 ? std::string{assignment} : std::string{assignment.substr(0, 77)} + "...";
    return std::invalid_argument{"\"" + said + "\": must be PATH=VALUE, e.g. rules.mutation.sd=0.1"};
  };
  if (equals == std::string_view::npos || equals == 0) throw bad();
  try {
    return parse_toml(assignment);
  } catch (const TomlError&) {
    try {
      const toml::value<std::string> text{std::string{assignment.substr(equals + 1)}};
      return parse_toml(std::string{assignment.substr(0, equals + 1)} + toml_text(text));
    } catch (const TomlError&) {
      throw bad();
    }
  }
}

}  // namespace trophic
