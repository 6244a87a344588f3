// SPDX-License-Identifier: MIT
// Writes TOML: all TOML files and listings of parameters of trophic's programs.
#pragma once

#include <ranges>
#include <trophic/params/named_params.hpp>
#include <trophic/params/parse_toml.hpp>
#include <trophic/params/toml_text.hpp>

namespace trophic {

/// Keys in insertion order, with comments; a toml::table keeps neither. Values: numbers (as toml_float), switches, enumerators
/// by name, texts (quoted as by toml++), pairs and ranges of values as lists, and structs with fields() as inline tables, one per
/// line.
class TomlWriter {
 public:
  /// Begins the table of a path: "evolution.params".
  void table(std::string_view path) { heading("[" + std::string{path} + "]"); }
  /// Begins the next element of an array of tables.
  void element(std::string_view path) { heading("[[" + std::string{path} + "]]"); }

  template <class Value>
  void put(std::string_view key, const Value& value, std::string_view comment = {}) {
    text_.append(key).append(" = ").append(written(value));
    if (!comment.empty()) text_.append("  # ").append(comment);
    text_ += '\n';
  }

  /// Writes every parameter in the table of its path, with its help as a comment; `root` is prepended to the paths.
  void put_all(const NamedParams& named_params, std::string_view root = {}) {
    std::string open{root};
    if (!root.empty()) table(root);
    for (const NamedParam& param : named_params) {
      const std::string path = join_path(root, param.path);
      const auto dot = path.rfind('.');
      const std::string in = dot == std::string::npos ? "" : path.substr(0, dot);
      if (in != open) table(open = in);
      const std::string_view key = std::string_view{path}.substr(dot == std::string::npos ? 0 : dot + 1);
      std::visit([&](const auto& value) { put(key, value, param.help); }, param.value);
    }
  }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  void heading(const std::string& line) {
    if (!text_.empty()) text_ += '\n';
    text_ += line + '\n';
  }

  template <class Value>
  [[nodiscard]] static std::string written(const Value& value) {
    if constexpr (std::same_as<Value, bool>) {
      return value ? "true" : "false";
    } else if constexpr (std::floating_point<Value>) {
      return toml_float(value);
    } else if constexpr (std::integral<Value>) {
      return number_text(value);
    } else if constexpr (NamedEnum<Value>) {
      return written(enum_name(value));
    } else if constexpr (std::convertible_to<Value, std::string_view>) {
      return toml_text(toml::value<std::string>{std::string{value}});
    } else if constexpr (HasFields<Value>) {
      std::string text;
      for_each_field(value, [&](const auto& field, const auto& member) {
        text.append(text.empty() ? "{ " : ", ").append(field.name).append(" = ").append(written(member));
      });
      return text + " }";
    } else if constexpr (std::ranges::range<Value>) {
      using Element = std::ranges::range_value_t<Value>;
      const std::string_view between = HasFields<Element> ? ",\n  " : ", ";
      std::string text;
      for (const Element& element : value) text.append(text.empty() ? "" : between).append(written(element));
      return HasFields<Element> ? "[\n  " + text + "\n]" : "[" + text + "]";
    } else {
      return "[" + written(value.first) + ", " + written(value.second) + "]";
    }
  }

  std::string text_;
};

/// NamedParams as a TOML text that reads back as the same parameters, with each field's help as a comment.
[[nodiscard]] inline std::string toml_text(const NamedParams& named_params) {
  TomlWriter writer;
  writer.put_all(named_params);
  return writer.text();
}

}  // namespace trophic
