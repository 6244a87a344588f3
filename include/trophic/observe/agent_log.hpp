// SPDX-License-Identifier: MIT
// agents.csv: every robot at every tick.
#pragma once

#include <filesystem>
#include <optional>
#include <trophic/observe/csv.hpp>
#include <trophic/population/view.hpp>

namespace trophic::observe {

/// One row per robot and tick, after that tick's rules.
/// Columns: time_s, tick, body, id, species, origin, active {0, 1}, tag, x_m, y_m, heading_rad, target_angle_rad, adversary_id,
/// adversary_distance_m (both empty without one), hunger_ticks (empty for those who hunt nobody).
class AgentLog {
 public:
  explicit AgentLog(const std::filesystem::path& path)
      : file_{path,
              "time_s,tick,body,id,species,origin,active,tag,x_m,y_m,heading_rad,target_angle_rad,adversary_id,"
              "adversary_distance_m,hunger_ticks"} {}

  void on_tick(const View& view) {
    for (BodyIndex body = 0; body < view.robots.size(); ++body) {
      const Individual& self = view.robots[body];
      const GroundPose& pose = view.poses[body];
      const auto adversary = self.adversary ? std::optional{view.robots[*self.adversary].id} : std::nullopt;
      const auto hunger = view.web.hunts(self.species) ? std::optional{view.hunger_ticks(self)} : std::nullopt;
      file_.row(view.time_s, view.tick, body, self.id, view.web.name(self.species), self.origin, self.active, self.tag,
                Decimal{pose.x_m}, Decimal{pose.y_m}, Decimal{pose.heading_rad}, Decimal{self.target_angle_rad}, adversary,
                Decimal{self.adversary_distance_m}, hunger);
    }
    file_.flush();
  }

 private:
  CsvFile file_;
};

}  // namespace trophic::observe
