// SPDX-License-Identifier: MIT
// The width of the terminal, and a line that fits it.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <trophic/support/linkage.hpp>

namespace trophic::observe {

[[nodiscard]] bool stderr_is_terminal();

/// Columns of the terminal on a file descriptor, or on stderr; otherwise $COLUMNS; otherwise 80.
[[nodiscard]] std::size_t terminal_columns(int descriptor);
[[nodiscard]] std::size_t terminal_columns();

/// Columns of a text, one for each UTF-8 character.
[[nodiscard]] std::size_t columns_of(const std::string& text);

/// Joins the parts, most important first, by two blanks: as many whole ones as fit in fewer than `columns` columns. The last
/// column stays free, so that no terminal wraps the line. A first part that does not fit is truncated.
[[nodiscard]] std::string fitting_line(std::span<const std::string> parts, std::size_t columns);

}  // namespace trophic::observe

#if TROPHIC_HEADER_ONLY
#include <trophic/observe/terminal.ipp>
#endif
