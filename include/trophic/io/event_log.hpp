// SPDX-License-Identifier: MIT
// events.csv: all events of individuals.
#pragma once

#include <trophic/io/csv_file.hpp>
#include <trophic/io/tables.hpp>
#include <trophic/observe/event.hpp>
#include <trophic/observe/run_description.hpp>
#include <trophic/population/view.hpp>

namespace trophic::io {

/// The row of an event in events.csv.
[[nodiscard]] inline EventRow event_row(const observe::Event& event, const View& view) {
  const Individual& self = event.individual;
  const bool is_catch = event.kind == observe::EventKind::capture;
  return {.time_s = view.time_s,
          .tick = view.tick,
          .kind = event.kind,
          .id = self.id,
          .species = self.species,
          .body = event.body,
          .tag = self.tag,
          .active = self.active,
          .origin = self.origin,
          .parent = self.parent(),
          .genome = self.genome->id,
          .cause = event.cause,
          .killer = is_catch ? std::nullopt : event.other,
          .victim = is_catch ? event.other : std::nullopt,
          .x_m = view.poses[event.body].x_m,
          .y_m = view.poses[event.body].y_m,
          .ancestor_list = ancestor_list_of(self)};
}

/// Writes an EventRow per event.
class EventLog : public CsvFile<EventRow> {
 public:
  static constexpr std::string_view file_name = "events.csv";

  explicit EventLog(const std::filesystem::path& path, Opening opening = Opening::created) : CsvFile{path, {}, opening} {}

  void on_start(const observe::RunDescription& run, const View&) {
    several_parents_ = run.several_parents;
    begin({.ancestor_list = several_parents_ ? std::optional{""} : std::nullopt});
  }
  void on_event(const observe::Event& event, const View& view) {
    EventRow row = event_row(event, view);
    if (!several_parents_) row.ancestor_list.reset();
    write(row, view.web);
  }
  void on_tick(const View&) { flush(); }

 private:
  bool several_parents_ = false;
};

}  // namespace trophic::io
