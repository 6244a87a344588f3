// SPDX-License-Identifier: MIT
// agents.csv: every robot at every tick.
#pragma once

#include <filesystem>
#include <optional>
#include <trophic/observe/csv.hpp>
#include <trophic/observe/tables.hpp>
#include <trophic/population/view.hpp>

namespace trophic::observe {

/// Writes an AgentRow per robot and tick.
class AgentLog {
 public:
  explicit AgentLog(const std::filesystem::path& path, Opening opening = Opening::made_new) : file_{path, opening} {}

  void on_tick(const View& view) {
    for (BodyIndex body = 0; body < view.robots.size(); ++body) {
      const Individual& self = view.robots[body];
      const GroundPose& pose = view.poses[body];
      file_.write({.time_s = view.time_s,
                   .tick = view.tick,
                   .body = body,
                   .id = self.id,
                   .species = self.species,
                   .origin = self.origin,
                   .active = self.active,
                   .tag = self.tag,
                   .x_m = pose.x_m,
                   .y_m = pose.y_m,
                   .heading_rad = pose.heading_rad,
                   .target_angle_rad = self.target_angle_rad,
                   .adversary = self.adversary ? std::optional{view.robots[*self.adversary].id} : std::nullopt,
                   .adversary_distance_m = self.adversary ? std::optional{self.adversary_distance_m} : std::nullopt,
                   .hunger_ticks = view.web.hunts(self.species) ? std::optional{view.hunger_ticks(self)} : std::nullopt},
                  view.web);
    }
    file_.flush();
  }

  void persist(Archive& archive) { archive(file_); }
  [[nodiscard]] TableSum sum() const { return file_.sum(); }

 private:
  CsvFile<AgentRow> file_;
};

}  // namespace trophic::observe
