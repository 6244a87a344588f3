// SPDX-License-Identifier: MIT
// Changes of a run's parameters while it runs, and their table.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <trophic/habitat/ecology_params.hpp>
#include <trophic/io/column.hpp>

namespace trophic::changes {

/// A number that takes another value at a moment of a run.
struct Change {
  double time_s = 0.0;      ///< the ecology's clock; it acts on all ticks after that moment
  std::string number = {};  ///< its path, "rules.capture.reach_m"
  std::string value = {};   ///< as --set reads it
  static constexpr auto saved() { return std::tuple{&Change::time_s, &Change::number, &Change::value}; }
  friend bool operator==(const Change&, const Change&) = default;
};

/// changes.csv: one row per observe::ParameterChange, in the order in which they were made. --changes reads it.
struct ChangeRow {
  double time_s = 0.0;
  std::int64_t tick = 0;
  std::string number = {};
  std::string value = {};
  std::string before = {};

  static constexpr auto columns() {
    return std::tuple{
        io::column("time_s", &ChangeRow::time_s, "s", "time by the ecology's clock; the change acts on later ticks", io::seconds),
        io::column("tick", &ChangeRow::tick, "", "index of the last decision step before the change"),
        io::column("number", &ChangeRow::number, "", "path of the parameter, as in --set"),
        io::column("value", &ChangeRow::value, "", "the new value"),
        io::column("before", &ChangeRow::before, "", "the value that it replaced")};
  }
};

/// In the folder of a run whose parameters may change.
inline constexpr std::string_view file_name = "changes.csv";

/// Largest number of changes of a run, and longest value in bytes: for those who make changes and those who read them.
inline constexpr std::size_t most_changes = 20'000;
inline constexpr std::size_t longest_value = 200;

/// Returns how many of these changes, which are due at one moment, are made together: all before a number's second one.
[[nodiscard]] std::size_t made_together(std::span<const Change> due);

/// Reads a table with the columns time_s, number and value, such as a run's changes.csv. Throws std::invalid_argument naming
/// file, line and value for a missing column, a moment that is not a number >= 0 or is earlier than the one above, or an empty
/// cell, and as read_whole_file.
[[nodiscard]] std::vector<Change> read_changes(const std::filesystem::path& path);

}  // namespace trophic::changes
