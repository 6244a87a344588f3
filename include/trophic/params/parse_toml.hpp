// SPDX-License-Identifier: MIT
// The only access to the TOML parser. Texts that would crash it, or exhaust memory or stack, are rejected first.
#pragma once

// For toml++ 3.3.0, as in Debian 12: in a debug build an assertion aborts the program on "[# a]". Without the assertion the
// parser reports the error.
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

/// An error in a TOML text, with its position. `line` and `column` count from 1.
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

/// Returns the table in a text. Throws TomlError for malformed texts, and for the following although TOML allows them: more than
/// 16 MiB, a line of more than 1 MiB, a key of more than 32 parts, values nested more than 64 levels deep, a quote in a word that
/// begins with a digit or a sign, two numbers separated by a space (a date and a time may be separated by T), and a non-ASCII
/// character outside texts and comments or after a backslash and spaces.
[[nodiscard]] toml::table parse_toml(std::string_view text);

/// Returns the table in a file. Throws std::invalid_argument "FILE:LINE:COLUMN: ..." or, if it cannot be read, "FILE: ...".
[[nodiscard]] toml::table parse_toml_file(const std::string& path);

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/params/parse_toml.ipp>
#endif
