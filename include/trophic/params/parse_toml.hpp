// SPDX-License-Identifier: MIT
// The only way to the TOML parser: what would break it, or take more memory or stack than there is, does not reach it.
#pragma once

// Of toml++ 3.3.0, as in Debian 12: a debug build's assertion ends the program on "[# a]". Without it the parser says what is
// wrong.
#ifndef TOML_ASSERT
#define TOML_ASSERT(expression) static_cast<void>(0)
#endif
#include <toml++/toml.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <trophic/support/linkage.hpp>

namespace trophic {

/// What is wrong with a TOML text, and where. `line` and `column` count from 1.
class TomlError : public std::invalid_argument {
 public:
  TomlError(std::size_t line, std::size_t column, const std::string& what)
      : std::invalid_argument{what}, line_{line}, column_{column} {}
  [[nodiscard]] std::size_t line() const noexcept { return line_; }
  [[nodiscard]] std::size_t column() const noexcept { return column_; }

 private:
  std::size_t line_;
  std::size_t column_;
};

/// The table that a text says. Throws TomlError for a text that is malformed or that TOML allows but nobody writes: more than 16
/// MiB, a line of more than 1 MiB, a key of more than 32 parts, values more than 64 deep, a quote in a word that begins with a
/// digit or a sign, two numbers with a blank between them (a date and a time may have T there), and a character that is not ASCII
/// outside of texts and comments or behind a backslash and blanks.
[[nodiscard]] toml::table parse_toml(std::string_view text);

/// The same of a file. Throws std::invalid_argument "FILE:LINE:COLUMN: ..." or, where it cannot be read, "FILE: ...".
[[nodiscard]] toml::table parse_toml_file(const std::string& path);

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/params/parse_toml.ipp>
#endif
