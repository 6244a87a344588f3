// SPDX-License-Identifier: MIT
// states.csv: the States of rules for every robot.
#pragma once

#include <trophic/io/csv_file.hpp>
#include <trophic/population/view.hpp>

namespace trophic::io {

/// One row per robot and tick, after that tick's rules: `StateLog log{path, ecology.state_columns()};`.
/// Columns: time_s, tick, body, id, then SLOT.MEMBER for each member of each State of
/// the table. Numbers are exact, an Ancestor is its id, a vector's numbers are separated by spaces, and an empty cell means no
/// value. Only the first four columns exist if no rule has a State.
class StateLog {
 public:
  static constexpr std::string_view section = "states.csv";
  static constexpr std::string_view file_name = "states.csv";

  /// `every_ticks`: only ticks that are multiples of this have rows.
  StateLog(const std::filesystem::path& path, StateColumns columns, Opening opening = Opening::created,
           std::int64_t every_ticks = 1)
      : append_{std::move(columns.append)},
        columns_{with_robot(std::move(columns.columns))},
        every_ticks_{every_ticks},
        file_{path, header_of(columns_), opening} {}

  void on_tick(const View& view) {
    if (view.tick % every_ticks_ != 0) return;
    for (BodyIndex body = 0; body < view.robots.size(); ++body) {
      if (!view.robots[body].lives()) continue;
      std::string& row = file_.buffer();
      detail::append_cell(row, view.time_s, seconds);
      row.push_back(',');
      detail::append_cell(row, view.tick);
      row.push_back(',');
      detail::append_cell(row, body);
      row.push_back(',');
      detail::append_cell(row, view.robots[body].id);
      if (append_) append_(body, row);
      row.push_back('\n');
    }
    file_.flush();
  }

  void persist(Archive& archive) { archive(file_); }
  [[nodiscard]] TableSum sum() const { return file_.sum(columns_); }

 private:
  [[nodiscard]] static std::vector<TypedColumn> with_robot(std::vector<TypedColumn> states) {
    std::vector<TypedColumn> columns{{"time_s", "double"}, {"tick", "int64"}, {"body", "int64"}, {"id", "int64"}};
    std::ranges::move(states, std::back_inserter(columns));
    return columns;
  }

  std::function<void(BodyIndex body, std::string& row)> append_;
  std::vector<TypedColumn> columns_;
  std::int64_t every_ticks_;
  LineFile file_;
};

}  // namespace trophic::io
