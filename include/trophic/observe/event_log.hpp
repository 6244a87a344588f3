// SPDX-License-Identifier: MIT
// events.csv: everything that happens to individuals.
#pragma once

#include <filesystem>
#include <optional>
#include <trophic/observe/csv.hpp>
#include <trophic/observe/event.hpp>
#include <trophic/population/view.hpp>

namespace trophic::observe {

/// One row per event, in the order in which they happened.
/// Columns: time_s, tick, event {birth, activation, tag_switch, catch, death}, id (whom it happens to; of a catch the hunter),
/// species, body, tag, active {0, 1}, origin {random, inherited}, parent_id, genome_id, cause {caught, starved, sacrificed,
/// senescence} and killer_id (deaths), victim_id (catches), x_m, y_m.
class EventLog {
 public:
  explicit EventLog(const std::filesystem::path& path)
      : file_{path, "time_s,tick,event,id,species,body,tag,active,origin,parent_id,genome_id,cause,killer_id,victim_id,x_m,y_m"} {
  }

  void on_event(const Event& event, const View& view) {
    const Individual& self = event.individual;
    const bool is_catch = event.kind == EventKind::capture;
    file_.row(view.time_s, view.tick, event.kind, self.id, view.web.name(self.species), event.body, self.tag, self.active,
              self.origin, self.parent, self.genome->id, event.cause, is_catch ? std::nullopt : event.other,
              is_catch ? event.other : std::nullopt, Decimal{view.poses[event.body].x_m}, Decimal{view.poses[event.body].y_m});
  }
  void on_tick(const View&) { file_.flush(); }
  void on_end(const View&) { file_.flush(); }

 private:
  CsvFile file_;
};

}  // namespace trophic::observe
