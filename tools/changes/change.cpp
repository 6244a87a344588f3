// SPDX-License-Identifier: MIT
// Definitions of change.hpp.
#include <cstdlib>
#include <set>
#include <tools/changes/change.hpp>
#include <trophic/io/own_table.hpp>
#include <trophic/params/params.hpp>
#include <trophic/support/whole_file.hpp>

namespace trophic::changes {

static_assert(io::is_run_table(file_name));

namespace detail {

/// The cells of a line. Values with a comma stand in quotes, as append_cell writes them.
[[nodiscard]] inline std::vector<std::string> cells_of(std::string_view line) {
  std::vector<std::string> cells(1);
  bool is_quoted = false;
  for (const char letter : line) {
    if (letter == '"') {
      is_quoted = !is_quoted;
    } else if (letter == ',' && !is_quoted) {
      cells.emplace_back();
    } else if (letter != '\r') {
      cells.back().push_back(letter);
    }
  }
  return cells;
}

/// The lines of a text, without the last end of line.
[[nodiscard]] inline std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    lines.push_back(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return lines;
}

}  // namespace detail

std::size_t made_together(std::span<const Change> due) {
  std::set<std::string_view> numbers;
  const auto again = std::ranges::find_if(due, [&](const Change& change) { return !numbers.insert(change.number).second; });
  return static_cast<std::size_t>(again - due.begin());
}

std::vector<Change> read_changes(const std::filesystem::path& path) {
  const std::string text = read_whole_file(path);
  const auto lines = detail::lines_of(text);
  const auto fail = [&](std::size_t line, const std::string& what) {
    throw std::invalid_argument{path.string() + " line " + std::to_string(line) + ": " + what};
  };
  const auto header = detail::cells_of(lines.empty() ? std::string_view{} : lines.front());
  constexpr std::array<std::string_view, 3> wanted{"time_s", "number", "value"};
  std::array<std::size_t, 3> places{};
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const auto found = std::ranges::find(header, wanted[i]);
    if (found == header.end()) fail(1, "the column " + std::string{wanted[i]} + " is missing");
    places[i] = static_cast<std::size_t>(found - header.begin());
  }
  if (lines.size() > most_changes + 1)
    fail(most_changes + 2, "must be omitted: a run can have at most " + std::to_string(most_changes) + " changes");
  std::vector<Change> changes;
  for (std::size_t line = 1; line < lines.size(); ++line) {
    if (lines[line].empty()) continue;
    const auto cells = detail::cells_of(lines[line]);
    if (cells.size() != header.size()) {
      fail(line + 1,
           std::to_string(cells.size()) + " cells: must be " + std::to_string(header.size()) + ", as in the first line");
    }
    const std::string& moment = cells[places[0]];
    Change change{.time_s = 0.0, .number = cells[places[1]], .value = cells[places[2]]};
    // libc++ 19 has no from_chars of floating-point numbers.
    char* end = nullptr;
    change.time_s = std::strtod(moment.c_str(), &end);
    const bool is_number = !moment.empty() && moment.find_first_not_of("0123456789.eE+-") == std::string::npos && *end == '\0';
    if (!is_number || !(change.time_s >= 0.0 && change.time_s <= longest_run_s))
      fail(line + 1, "time_s = " + moment + ": must be >= 0 and <= " + number_text(longest_run_s));
    if (!changes.empty() && change.time_s < changes.back().time_s) {
      fail(line + 1, "time_s = " + moment + ": must be >= " + number_text(changes.back().time_s) + ", as in the line above");
    }
    if (change.number.empty()) fail(line + 1, "number: must not be empty");
    if (change.value.empty()) fail(line + 1, "value: must not be empty");
    if (change.value.size() > longest_value) fail(line + 1, "value: must have <= " + std::to_string(longest_value) + " bytes");
    changes.push_back(std::move(change));
  }
  return changes;
}

}  // namespace trophic::changes
