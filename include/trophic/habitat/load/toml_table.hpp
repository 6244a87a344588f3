// SPDX-License-Identifier: MIT
// Reads TOML data files with errors that name file, key and value.
#pragma once

#include <filesystem>
#include <set>
#include <stdexcept>
#include <trophic/habitat/load/foreign_format.hpp>
#include <trophic/params/params.hpp>
#include <trophic/params/parse_toml.hpp>
#include <trophic/params/toml_text.hpp>
#include <trophic/support/plain_text.hpp>
#include <trophic/support/whole_file.hpp>
#include <vector>

namespace trophic::detail {

/// A table of a TOML file. Records which keys were read, so that `no_other_keys` can reject the rest.
class TomlTable {
 public:
  /// Throws std::invalid_argument "FILE: ..." if the file cannot be read, "FILE:LINE:COLUMN: ..." for malformed TOML.
  [[nodiscard]] static TomlTable read(const std::filesystem::path& file) { return parse(read_whole_file(file), file.string()); }

  /// Reads a text; `file` is its name in errors.
  [[nodiscard]] static TomlTable parse(std::string_view text, const std::string& file) {
    try {
      return {file, "", parse_toml(text)};
    } catch (const TomlError& error) {
      if (const std::string foreign = about_foreign_format(text); !foreign.empty()) throw std::invalid_argument{file + foreign};
      throw std::invalid_argument{file + ":" + std::to_string(error.line()) + ":" + std::to_string(error.column()) + ": " +
                                  error.what()};
    }
  }

  [[noreturn]] void fail(std::string_view key, const std::string& what) const {
    throw std::invalid_argument{file_ + ": " + join_path(path_, key) + what};
  }

  [[nodiscard]] bool has(std::string_view key) const { return node(key) != nullptr; }

  [[nodiscard]] std::string text(std::string_view key) const {
    const toml::node& value = required(key);
    return plain_text(key, value);
  }

  [[nodiscard]] bool truth(std::string_view key) const {
    const toml::node& value = required(key);
    if (const auto truth = value.value_exact<bool>()) return *truth;
    fail(key, " = " + toml_text(value) + ": must be true or false");
  }

  [[nodiscard]] double number(std::string_view key, const Bound& bound) const {
    const double value = plain_number(key, required(key));
    check(key, value, bound);
    return value;
  }

  [[nodiscard]] std::size_t whole_number(std::string_view key, std::int64_t lower) const {
    const toml::node& value = required(key);
    const auto whole = value.value_exact<std::int64_t>();
    if (!whole || *whole < lower) fail(key, " = " + toml_text(value) + ": must be a whole number >= " + std::to_string(lower));
    return static_cast<std::size_t>(*whole);
  }

  [[nodiscard]] std::vector<double> numbers(std::string_view key) const {
    std::vector<double> result;
    for (const toml::node& item : array(key)) result.push_back(plain_number(key, item));
    return result;
  }

  [[nodiscard]] std::vector<std::vector<double>> rows(std::string_view key) const {
    std::vector<std::vector<double>> result;
    for (const toml::node& row : array(key)) {
      if (!row.is_array()) fail(key, " = " + toml_text(row) + ": must be a row of numbers");
      result.emplace_back();
      for (const toml::node& item : *row.as_array()) result.back().push_back(plain_number(key, item));
    }
    return result;
  }

  [[nodiscard]] std::vector<std::string> texts(std::string_view key) const {
    std::vector<std::string> result;
    for (const toml::node& item : array(key)) result.push_back(plain_text(key, item));
    return result;
  }

  [[nodiscard]] TomlTable table(std::string_view key) const {
    const toml::node& value = required(key);
    if (!value.is_table()) fail(key, " = " + toml_text(value) + ": must be a table");
    return {file_, join_path(path_, key), *value.as_table()};
  }

  [[nodiscard]] std::vector<TomlTable> tables(std::string_view key) const {
    std::vector<TomlTable> result;
    for (const toml::node& item : array(key)) {
      if (!item.is_table()) fail(key, " = " + toml_text(item) + ": must be a table");
      result.push_back({file_, join_path(path_, key) + "[" + std::to_string(result.size()) + "]", *item.as_table()});
    }
    return result;
  }

  /// Overwrites the members of a Params struct that the table contains (numbers and nested Params).
  template <class P>
  void read_fields(P& params) const {
    for_each_field(params, [&](const auto& f, auto& value) {
      if (!has(f.name)) return;
      if constexpr (HasFields<std::remove_cvref_t<decltype(value)>>) {
        const TomlTable inner = table(f.name);
        inner.read_fields(value);
        inner.no_other_keys();
      } else {
        value = number(f.name, f.bound);
      }
    });
  }

  /// Throws std::invalid_argument for the first key that was not read.
  void no_other_keys() const {
    for (const auto& [key, value] : table_) {
      if (!asked_.contains(std::string{key.str()})) {
        std::string known;
        for (const std::string& name : asked_) known += (known.empty() ? "" : ", ") + name;
        fail(key.str(), ": unknown key; known here: " + known);
      }
    }
  }

 private:
  TomlTable(std::string file, std::string path, toml::table table)
      : file_{std::move(file)}, path_{std::move(path)}, table_{std::move(table)} {}

  [[nodiscard]] const toml::node* node(std::string_view key) const {
    asked_.emplace(key);
    return table_.get(key);
  }

  [[nodiscard]] const toml::node& required(std::string_view key) const {
    const toml::node* found = node(key);
    if (found == nullptr) fail(key, ": missing");
    return *found;
  }

  [[nodiscard]] const toml::array& array(std::string_view key) const {
    const toml::node& value = required(key);
    if (!value.is_array()) fail(key, " = " + toml_text(value) + ": must be a list");
    return *value.as_array();
  }

  [[nodiscard]] std::string plain_text(std::string_view key, const toml::node& value) const {
    const auto text = value.value_exact<std::string>();
    if (!text) fail(key, " = " + toml_text(value) + ": must be a text");
    if (!is_plain(*text)) fail(key, " = " + toml_text(value) + ": must be a text without control characters");
    return *text;
  }

  [[nodiscard]] double plain_number(std::string_view key, const toml::node& value) const {
    if (!value.is_number()) fail(key, " = " + toml_text(value) + ": must be a number");
    const auto number = value.value<double>();
    if (!number) fail(key, " = " + toml_text(value) + ": must be from -2^53 to 2^53, or have a decimal point");
    return *number;
  }

  void check(std::string_view key, double value, const Bound& bound) const {
    const bool low = bound.lower_excluded ? !(value > bound.lower) : !(value >= bound.lower);
    if (!std::isfinite(value) || low || value > bound.upper) fail(key, " = " + number_text(value) + ": " + bound_text(bound));
  }

  std::string file_;
  std::string path_;
  toml::table table_;
  mutable std::set<std::string> asked_;
};

}  // namespace trophic::detail
