// SPDX-License-Identifier: MIT
// Columns: the row of a table lists them once; the header and cells of its file, its reader and docs/tables.md follow that list.
#pragma once

#include <string_view>
#include <trophic/params/detail/member_count.hpp>
#include <trophic/population/food_web.hpp>
#include <tuple>

namespace trophic::io {

/// Format of a cell. Numbers are written in their shortest exact form unless `decimals` >= 0 fixes their count.
struct Written {
  int decimals = -1;
  std::string_view none = {};  ///< written for an empty optional
  bool plain = false;          ///< never with an exponent: 100000, not 1e+05
  bool if_any = false;         ///< for an optional: a file has the column only if its rows have values
};

/// Seconds of the ecology's clock.
inline constexpr Written seconds{.decimals = -1, .none = {}, .plain = true};

/// Metres have six decimals: a micrometre.
inline constexpr Written micro{.decimals = 6};

/// A member of a row with the name of its column. `unit`: "s", "m", "rad"; empty if there is none.
template <class Row, class T>
struct Column {
  std::string_view name;
  T Row::*member;
  std::string_view unit;
  std::string_view help;
  Written written;
};

/// A species: an index in a row, a name in a cell.
template <class Row>
struct SpeciesColumn {
  std::string_view name;
  Species Row::*member;
  std::string_view help;
};

/// One column per number in a row: w0, w1, ... Every row of a file has the same count.
template <class Row>
struct ListColumns {
  std::string_view name;
  std::vector<double> Row::*member;
  std::string_view unit;
  std::string_view help;
};

/// Numbers with a name for each.
struct NamedNumbers {
  std::vector<std::string> names = {};
  std::vector<double> values = {};
};

/// One column per named number in a row: NAME_output for each name with the suffix "_output".
template <class Row>
struct NamedColumns {
  std::string_view name;  ///< the suffix
  NamedNumbers Row::*member;
  std::string_view unit;
  std::string_view help;
};

template <class Row, class T>
[[nodiscard]] constexpr Column<Row, T> column(std::string_view name, T Row::*member, std::string_view unit, std::string_view help,
                                              Written written = {}) {
  return {name, member, unit, help, written};
}
template <class Row>
[[nodiscard]] constexpr SpeciesColumn<Row> species_column(std::string_view name, Species Row::*member, std::string_view help) {
  return {name, member, help};
}
template <class Row>
[[nodiscard]] constexpr ListColumns<Row> list_columns(std::string_view name, std::vector<double> Row::*member,
                                                      std::string_view unit, std::string_view help) {
  return {name, member, unit, help};
}
template <class Row>
[[nodiscard]] constexpr NamedColumns<Row> named_columns(std::string_view ending, NamedNumbers Row::*member,
                                                        std::string_view help) {
  return {ending, member, {}, help};
}

template <class C>
inline constexpr bool is_species_column = false;
template <class Row>
inline constexpr bool is_species_column<SpeciesColumn<Row>> = true;
template <class C>
inline constexpr bool is_list_columns = false;
template <class Row>
inline constexpr bool is_list_columns<ListColumns<Row>> = true;
template <class C>
inline constexpr bool is_named_columns = false;
template <class Row>
inline constexpr bool is_named_columns<NamedColumns<Row>> = true;

/// Whether a column is omitted in a file whose rows have values like this one.
template <class C, class Row>
[[nodiscard]] bool is_left_out(const C& column, const Row& row) {
  if constexpr (requires { column.written.if_any && (row.*column.member).has_value(); })
    return column.written.if_any && !(row.*column.member).has_value();
  return false;
}

/// A struct that lists its columns: `static constexpr auto columns() { return std::tuple{column("time_s", &Row::time_s, "s",
/// "the ecology's clock"), ...}; }`, one for each member.
template <class Row>
concept TableRow = requires {
  std::tuple_size<decltype(Row::columns())>::value;
};

/// Calls `visit(column)` for each in the order of the file.
template <TableRow Row, class Visitor>
constexpr void for_each_column(Visitor&& visit) {
  static_assert(trophic::detail::member_count<Row>() == std::tuple_size_v<decltype(Row::columns())>,
                "a row must show every member in columns(); see trophic/io/column.hpp");
  std::apply([&](const auto&... column) { (visit(column), ...); }, Row::columns());
}

}  // namespace trophic::io
