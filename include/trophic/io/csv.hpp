// SPDX-License-Identifier: MIT
// CSV: rows as text, according to their columns.
#pragma once

#include <cmath>
#include <functional>
#include <span>
#include <sstream>
#include <trophic/io/column.hpp>
#include <trophic/params/params.hpp>
#include <trophic/population/individual.hpp>

namespace trophic::io {

namespace detail {

template <class... Format>
void append_number(std::string& text, Format... format) {
  std::array<char, 400> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), format...);
  text.append(digits.data(), end.ptr);
}

/// Writes a number with `decimals` decimals, with the same digits as std::to_chars but faster. Rounding the product is correct
/// unless the number is near the midpoint of two results: below 2^40 the error of the product is below 2^-13.
inline void append_fixed(std::string& text, double value, int decimals) {
  constexpr std::array<double, 7> powers{1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6};
  const bool is_known = decimals >= 1 && static_cast<std::size_t>(decimals) < powers.size();
  const double scaled = is_known ? std::abs(value) * powers[static_cast<std::size_t>(decimals)] : 0.0;
  auto whole = is_known && scaled < 0x1p40 ? static_cast<std::uint64_t>(scaled + 0.5) : 0;
  const bool is_sure = is_known && std::abs(scaled - static_cast<double>(whole)) < 0.499;
  if (!is_sure) return append_number(text, value, std::chars_format::fixed, decimals);
  std::array<char, 24> digits;
  char* first = digits.data() + digits.size();
  for (int i = 0; whole != 0 || i <= decimals; ++i, whole /= 10) {
    if (i == decimals) *--first = '.';
    *--first = static_cast<char>('0' + whole % 10);
  }
  if (std::signbit(value)) *--first = '-';
  text.append(first, digits.data() + digits.size());
}

/// Numbers in the format `written`, NaN as an empty cell, switches as 0 and 1, enumerators by name, texts in quotes if they have
/// a comma.
template <class Cell>
void append_cell(std::string& text, const Cell& value, const Written& written = {}) {
  if constexpr (std::same_as<Cell, bool>) {
    text.push_back(value ? '1' : '0');
  } else if constexpr (std::floating_point<Cell>) {
    if (!(value == value)) return;
    if (written.decimals < 0 && written.plain) return append_number(text, value, std::chars_format::fixed);
    if (written.decimals < 0) return append_number(text, value);
    append_fixed(text, value, written.decimals);
  } else if constexpr (std::integral<Cell>) {
    append_number(text, value);
  } else if constexpr (NamedEnum<Cell>) {
    text.append(enum_name(value));
  } else if constexpr (requires { value.has_value(); }) {
    if (value) return append_cell(text, *value, written);
    text.append(written.none);
  } else {
    const std::string_view plain{value};
    const std::string_view quote = plain.find(',') == std::string_view::npos ? "" : "\"";
    text.append(quote).append(plain).append(quote);
  }
}

}  // namespace detail

/// The names of a table's columns as a line; `like` is a row with the columns and the lengths of lists of every row.
template <TableRow Row>
[[nodiscard]] std::string header_of(const Row& like = {}) {
  std::string text;
  for_each_column<Row>([&](const auto& column) {
    if (is_left_out(column, like)) return;
    if constexpr (is_list_columns<std::remove_cvref_t<decltype(column)>>) {
      for (std::size_t i = 0; i < (like.*column.member).size(); ++i) text.append(column.name).append(number_text(i) + ",");
    } else if constexpr (is_named_columns<std::remove_cvref_t<decltype(column)>>) {
      for (const std::string& name : (like.*column.member).names) text.append(name).append(column.name).push_back(',');
    } else {
      text.append(column.name).push_back(',');
    }
  });
  text.back() = '\n';
  return text;
}

/// A row as a line. `web` names the species of rows that have one.
template <TableRow Row>
void append_row(std::string& text, const Row& row, const FoodWeb& web) {
  for_each_column<Row>([&](const auto& column) {
    if (is_left_out(column, row)) return;
    using Kind = std::remove_cvref_t<decltype(column)>;
    const auto& value = row.*column.member;
    const auto append_all = [&](const std::vector<double>& numbers) {
      for (const double number : numbers) {
        detail::append_cell(text, number);
        text.push_back(',');
      }
    };
    if constexpr (is_list_columns<Kind>) {
      append_all(value);
    } else if constexpr (is_named_columns<Kind>) {
      append_all(value.values);
    } else {
      if constexpr (is_species_column<Kind>) {
        detail::append_cell(text, web.name(value));
      } else {
        detail::append_cell(text, value, column.written);
      }
      text.push_back(',');
    }
  });
  text.back() = '\n';
}

/// The Arrow name of the type of cells.
template <class Cell>
inline constexpr std::string_view type_name = std::integral<Cell>         ? "int64"
                                              : std::floating_point<Cell> ? "double"
                                                                          : "string";
template <class Cell>
inline constexpr std::string_view type_name<std::optional<Cell>> = type_name<Cell>;

/// The name and the type (type_name) of a column.
using TypedColumn = std::pair<std::string, std::string_view>;

/// The columns of a table except those of lists, which are numbers.
template <TableRow Row>
[[nodiscard]] std::vector<TypedColumn> typed_columns() {
  std::vector<TypedColumn> columns;
  for_each_column<Row>([&](const auto& column) {
    using Kind = std::remove_cvref_t<decltype(column)>;
    using Cell = std::remove_cvref_t<decltype(Row{}.*column.member)>;
    if constexpr (is_species_column<Kind>) {
      columns.emplace_back(column.name, "string");
    } else if constexpr (!is_list_columns<Kind> && !is_named_columns<Kind>) {
      columns.emplace_back(column.name, type_name<Cell>);
    }
  });
  return columns;
}

/// The names of columns as a line.
[[nodiscard]] inline std::string header_of(const std::vector<TypedColumn>& columns) {
  std::string text;
  for (const auto& [name, type] : columns) text.append(name).push_back(',');
  text.back() = '\n';
  return text;
}

/// Number of rows of a table, without its header, the CRC-32 of its file, and its columns.
struct TableSum {
  static constexpr std::size_t longest_header = std::size_t{1} << 20U;  ///< bytes of a first line
  std::uint64_t rows = 0;
  std::uint32_t crc32 = 0;
  std::vector<TypedColumn> columns = {};

  /// The columns in a table's first line: a known name has its type, and unknown names are numbers of a list.
  void add_columns(std::string_view table, const std::vector<TypedColumn>& known) {
    std::istringstream names{std::string{table.substr(0, table.find('\n'))}};
    for (std::string name; std::getline(names, name, ',');) {
      const auto one = std::ranges::find(known, name, &TypedColumn::first);
      columns.emplace_back(name, one == known.end() ? "double" : one->second);
    }
  }
};

/// A whole table of rows without species.
template <TableRow Row>
[[nodiscard]] std::string table_text(std::span<const Row> rows) {
  std::string text = header_of<Row>();
  const FoodWeb no_species{{}, {}};
  for (const Row& row : rows) append_row(text, row, no_species);
  return text;
}

/// The states of rules with a State, as text; state_columns.hpp makes this from a table's states.
struct StateColumns {
  std::vector<TypedColumn> columns = {};                                   ///< SLOT.MEMBER
  std::function<void(BodyIndex body, std::string& row)> append = nullptr;  ///< a comma and a cell for each column
};

}  // namespace trophic::io
