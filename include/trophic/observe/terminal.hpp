// SPDX-License-Identifier: MIT
// The width of the terminal, and a line that fits it.
#pragma once

#include <sys/ioctl.h>
#include <unistd.h>
#include <trophic/support/cpp20.hpp>

#include <cstddef>
#include <cstdlib>
#include <span>
#include <string>

namespace trophic::observe {

[[nodiscard]] inline bool stderr_is_terminal() {
  return ::isatty(STDERR_FILENO) != 0;
}

/// Columns of the terminal on a file descriptor, or on stderr; otherwise $COLUMNS; otherwise 80.
[[nodiscard]] inline std::size_t terminal_columns(int descriptor = STDERR_FILENO) {
  ::winsize size{};
  if (::ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
  const char* text = std::getenv("COLUMNS");
  const long columns = text == nullptr ? 0 : std::strtol(text, nullptr, 10);
  return columns > 0 && columns <= 10'000 ? static_cast<std::size_t>(columns) : 80;
}

/// Columns of a text, one per UTF-8 character.
[[nodiscard]] inline std::size_t columns_of(const std::string& text) {
  std::size_t columns = 0;
  for (const char c : text) columns += (static_cast<unsigned char>(c) & 0xC0U) != 0x80U ? 1 : 0;
  return columns;
}

/// Joins the parts, most important first, with two spaces: as many whole parts as fit in fewer than `columns` columns. The last
/// column stays free, so that terminals do not wrap the line. A first part that does not fit is truncated.
[[nodiscard]] inline std::string fitting_line(std::span<const std::string> parts, std::size_t columns) {
  std::string line;
  for (const std::string& part : parts) {
    if (part.empty()) continue;
    const std::string longer = line.empty() ? part : line + "  " + part;
    if (columns_of(longer) < columns) {
      line = longer;
      continue;
    }
    if (!line.empty()) return line;
    line = longer;
    while (!line.empty() && columns_of(line) >= columns) line.pop_back();
    return line;
  }
  return line;
}

}  // namespace trophic::observe
