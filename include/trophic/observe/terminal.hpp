// SPDX-License-Identifier: MIT
// How wide the terminal is, and a line that fits it.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <trophic/support/linkage.hpp>

namespace trophic::observe {

[[nodiscard]] bool stderr_is_terminal();

/// Columns of the terminal that a file descriptor is, or that stderr is; where it is none, of $COLUMNS; where that says
/// nothing, 80.
[[nodiscard]] std::size_t terminal_columns(int descriptor);
[[nodiscard]] std::size_t terminal_columns();

/// Columns that a text takes, one for each character of UTF-8.
[[nodiscard]] std::size_t columns_of(const std::string& text);

/// The parts, most important first, two blanks between them, as many whole ones as fit in fewer than `columns` columns: the last
/// column stays free, so that no terminal wraps the line. A first part that does not fit is cut.
[[nodiscard]] std::string fitting_line(std::span<const std::string> parts, std::size_t columns);

}  // namespace trophic::observe

#if TROPHIC_HEADER_ONLY
#include <trophic/observe/terminal.ipp>
#endif
