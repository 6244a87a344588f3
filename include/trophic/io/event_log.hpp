// SPDX-License-Identifier: MIT
// events.csv: all events of individuals.
#pragma once

#include <trophic/io/csv_file.hpp>
#include <trophic/io/tables.hpp>
#include <trophic/observe/event.hpp>
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
          .y_m = view.poses[event.body].y_m};
}

/// Writes an EventRow per event.
class EventLog : public CsvFile<EventRow> {
 public:
  using CsvFile::CsvFile;
  static constexpr std::string_view file_name = "events.csv";

  void on_event(const observe::Event& event, const View& view) { write(event_row(event, view), view.web); }
  void on_tick(const View&) { flush(); }
};

}  // namespace trophic::io
