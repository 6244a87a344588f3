// SPDX-License-Identifier: MIT
// Definitions of parse_toml.hpp.
#pragma once

#include <algorithm>
#include <trophic/params/parse_toml.hpp>
#include <trophic/support/whole_file.hpp>

namespace trophic {

namespace detail {

inline constexpr std::size_t most_toml_bytes = std::size_t{16} << 20U;
inline constexpr std::size_t most_toml_line = std::size_t{1} << 20U;
inline constexpr std::size_t most_key_parts = 32;
inline constexpr std::size_t most_toml_depth = 64;

/// Scans a text once, keeps track of quotes and comments, and throws TomlError for texts that must not reach the parser.
class TomlFence {
 public:
  explicit TomlFence(std::string_view text) : text_{text} {}

  void check() {
    if (text_.size() > most_toml_bytes) fail("has " + std::to_string(text_.size()) + " bytes: must be <= 16 MiB");
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '#') {
        skip_comment();
      } else if (c == '"' || c == '\'') {
        skip_quoted(c);
      } else {
        plain(c);
        step();
      }
    }
  }

 private:
  static constexpr std::string_view blanks = " \t\n\v\f\r";
  static bool is_one_of(std::string_view characters, char c) { return characters.find(c) != std::string_view::npos; }
  static bool is_ascii(char c) { return static_cast<unsigned char>(c) < 0x80; }

  [[noreturn]] void fail(const std::string& what) const { throw TomlError{line_, at_ - line_start_ + 1, what}; }

  void step() {
    if (text_[at_] == '\n') {
      ++line_;
      line_start_ = at_ + 1;
    } else if (at_ - line_start_ > most_toml_line) {
      fail("a line of more than 1 MiB");
    }
    ++at_;
  }

  void skip_comment() {
    while (at_ < text_.size() && text_[at_] != '\n') step();
  }

  void skip_quoted(char quote) {
    if (in_number_) fail("a quote in a word that begins with a digit or a sign");
    const std::string three(3, quote);
    const bool is_long = text_.substr(at_).starts_with(three);
    for (int i = 0; i < (is_long ? 3 : 1); ++i) step();
    while (at_ < text_.size()) {
      if (quote == '"' && text_[at_] == '\\') {
        skip_escape();
        continue;
      }
      if (is_long ? text_.substr(at_).starts_with(three) : text_[at_] == quote || text_[at_] == '\n') {
        for (int i = 0; i < (is_long ? 3 : 1); ++i) step();
        for (int i = 0; is_long && i < 2 && text_.substr(at_).starts_with(quote); ++i) step();  // """"" ends in two of the text
        return;
      }
      step();
    }
  }

  /// A backslash and the character that it escapes, or all spaces and line ends after it, which the parser searches with the
  /// function that fails on a non-ASCII character.
  void skip_escape() {
    step();
    const std::size_t begin = at_;
    while (at_ < text_.size() && is_one_of(blanks, text_[at_])) step();
    if (at_ < text_.size() && !is_ascii(text_[at_])) fail("a non-ASCII character after a backslash");
    if (at_ < text_.size() && at_ == begin) step();
  }

  /// The parser reads everything adjacent to a number as part of it, including quotes, and after a date and a space even a line
  /// end.
  void check_number(char c) {
    constexpr std::string_view digits_and_signs = "0123456789+-";
    const bool begins = at_ == 0 || is_one_of(blanks, text_[at_ - 1]) || is_one_of("=,[{", text_[at_ - 1]);
    if (c == ' ' && in_number_ && at_ + 1 < text_.size() && is_one_of(digits_and_signs, text_[at_ + 1])) {
      fail("two numbers separated only by a space");
    }
    if (is_one_of(blanks, c) || is_one_of(",]}", c)) {
      in_number_ = false;
    } else if (begins && is_one_of(digits_and_signs, c)) {
      in_number_ = true;
    }
  }

  void plain(char c) {
    if (!is_ascii(c)) fail("a non-ASCII character outside quotes");
    check_number(c);
    if (c == '[' || c == '{') {
      if (++depth_ > most_toml_depth) fail("brackets nested more than 64 levels deep");
    } else if (c == ']' || c == '}') {
      depth_ = depth_ == 0 ? 0 : depth_ - 1;
    }
    if (c == '.') {
      if (++dots_ >= most_key_parts) fail("a key of more than 32 parts");
    } else if (c == '\n' || c == '=' || c == ',') {
      dots_ = 0;
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  std::size_t line_start_ = 0;
  std::size_t depth_ = 0;
  std::size_t dots_ = 0;
  bool in_number_ = false;
};

}  // namespace detail

TROPHIC_INLINE toml::table parse_toml(std::string_view text) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  detail::TomlFence{text}.check();
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    const auto& place = error.source().begin;
    throw TomlError{std::max<std::size_t>(place.line, 1), std::max<std::size_t>(place.column, 1),
                    std::string{error.description()}};
  }
}

TROPHIC_INLINE toml::table parse_toml_file(const std::string& path) {
  const std::string text = read_whole_file(path, detail::most_toml_bytes);
  try {
    return parse_toml(text);
  } catch (const TomlError& error) {
    throw std::invalid_argument{path + ":" + std::to_string(error.line()) + ":" + std::to_string(error.column()) + ": " +
                                error.what()};
  }
}

}  // namespace trophic
