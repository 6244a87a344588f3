// SPDX-License-Identifier: MIT
// A strict reader of plain CSV files: what it does not understand it reports with file, line and column.
#pragma once

#include <initializer_list>
#include <trophic/io/csv_file.hpp>
#include <trophic/support/plain_text.hpp>

namespace trophic::analysis {

/// Reads the files that io::CsvFile writes: one header row, commas, quotes only around a cell with a comma, every row as many
/// cells as the header and ended by a newline. Only the columns asked for are looked at; they may stand anywhere. A last line
/// without its newline, of a writer that was killed, is not a row: truncated() returns true.
class CsvReader {
 public:
  /// Throws std::runtime_error "FILE: ..." if it cannot be read, has no header or lacks one of `columns`.
  CsvReader(const std::filesystem::path& path, std::initializer_list<std::string_view> columns);

  [[nodiscard]] bool has(std::string_view column) const { return std::ranges::find(header_, column) != header_.end(); }

  /// Asks for one more column. Throws std::runtime_error where the file lacks it.
  void want(std::string_view column);
  [[nodiscard]] const std::vector<std::string>& header() const { return header_; }
  [[nodiscard]] bool is_wanted(std::string_view column) const { return place_of(column) < wanted_.size(); }

  /// Goes to the next row; false after the last. Throws std::runtime_error "FILE:LINE: ..." for a wrong number of cells.
  bool next();

  [[nodiscard]] std::size_t line() const { return line_; }
  /// Whether the file ended in the middle of a line; known once next() is false.
  [[nodiscard]] bool truncated() const { return truncated_; }

  /// The cell in the row at hand of the column that was asked for at this place.
  [[nodiscard]] std::string_view text(std::size_t column) const { return cells_[wanted_.at(column).place]; }

  /// A text, a number, {0, 1} as a bool, or an enumerator by name. Throws std::runtime_error "FILE:LINE: COLUMN = "TEXT": must be
  /// ...".
  template <class T>
  [[nodiscard]] T get(std::size_t column) const {
    const std::string_view cell = text(column);
    if constexpr (std::is_same_v<T, bool>) {
      if (cell != "0" && cell != "1") reject(column, "0 or 1");
      return cell == "1";
    } else if constexpr (std::same_as<T, std::string>) {
      if (!is_plain(cell)) reject(column, "text without control characters");
      return std::string{cell};
    } else if constexpr (std::same_as<T, Cause>) {
      if (!is_cause_name(cell)) reject(column, "the name of a cause");
      return cause_named(cell);
    } else if constexpr (NamedEnum<T>) {
      constexpr auto names = enum_names(T{});
      const auto found = std::ranges::find(names, cell);
      if (found == names.end()) reject(column, "one of the names that the program writes");
      return static_cast<T>(found - names.begin());
    } else {
      T value{};
      const auto parsed = std::from_chars(cell.data(), cell.data() + cell.size(), value);
      if (parsed.ec != std::errc{} || parsed.ptr != cell.data() + cell.size()) {
        reject(column, std::is_integral_v<T> ? "a whole number in range" : "a number");
      }
      if constexpr (std::is_floating_point_v<T>) {
        if (!(value - value == T{0})) reject(column, "finite");
      }
      return value;
    }
  }
  /// None for an empty cell, or for what stands for none in this column.
  template <class T>
  [[nodiscard]] std::optional<T> get_optional(std::size_t column, std::string_view none = {}) const {
    return text(column) == none ? std::nullopt : std::optional{get<T>(column)};
  }

  /// The position of a name among the wanted columns; it must be one of them.
  [[nodiscard]] std::size_t place_of(std::string_view column) const;
  [[noreturn]] void reject(std::size_t column, std::string_view must) const;
  /// An error about a line of this file, for the caller to throw.
  [[nodiscard]] std::runtime_error error(std::size_t line, const std::string& what) const;

 private:
  struct Wanted {
    std::string name;
    std::size_t place;
  };

  [[nodiscard]] std::runtime_error error(const std::string& what) const { return std::runtime_error{file_ + ": " + what}; }

  bool split_line();

  static constexpr std::uint64_t largest_table = std::uint64_t{64} << 30U;

  std::string file_;
  std::string text_;
  std::size_t at_ = 0;
  std::size_t line_ = 0;
  bool truncated_ = false;
  std::vector<std::string> header_;
  std::vector<Wanted> wanted_;
  std::vector<std::string_view> cells_;
};

}  // namespace trophic::analysis
