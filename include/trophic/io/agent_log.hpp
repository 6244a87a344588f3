// SPDX-License-Identifier: MIT
// agents.csv: every robot at every tick or every n-th tick.
#pragma once

#include <trophic/io/csv_file.hpp>
#include <trophic/io/tables.hpp>
#include <trophic/population/view.hpp>

namespace trophic::io {

namespace detail {

/// The traits and acts of the individual that lives in a body; only names for a spare body.
[[nodiscard]] inline NamedNumbers own_numbers(const View& view, BodyIndex body) {
  NamedNumbers own{.names = {view.traits.begin(), view.traits.end()}, .values = {}};
  if (view.robots[body].genome) own.values = view.robots[body].genome->traits;
  for (std::size_t place = 0; place < view.acts.names.size(); ++place) {
    if (view.acts.names[place].empty()) continue;
    own.names.emplace_back(view.acts.names[place]);
    own.values.push_back(view.acts.values[body * view.acts.names.size() + place]);
  }
  return own;
}

}  // namespace detail

/// The row of the individual that currently lives in a body.
[[nodiscard]] inline AgentRow agent_row(const View& view, BodyIndex body) {
  const Individual& self = view.robots[body];
  const GroundPose& pose = view.poses[body];
  return {.time_s = view.time_s,
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
          .hunger_ticks = view.web.hunts(self.species) ? std::optional{view.hunger_ticks(self)} : std::nullopt,
          .energy_J = view.energy.empty() ? std::nullopt : std::optional{self.energy_J},
          .own = detail::own_numbers(view, body)};
}

/// Writes an AgentRow per robot and tick, or only at the ticks whose number is a multiple of `every_ticks`.
class AgentLog {
 public:
  static constexpr std::string_view file_name = "agents.csv";

  /// Throws std::invalid_argument unless `every_ticks` >= 1. With `Opening::resumed`, call `persist` next: the file keeps its
  /// original interval.
  explicit AgentLog(const std::filesystem::path& path, Opening opening = Opening::created, std::int64_t every_ticks = 1)
      : every_ticks_{checked(every_ticks)}, file_{path, std::nullopt, opening} {}

  void on_tick(const View& view) {
    if (view.tick % every_ticks_ != 0) return;
    file_.begin(agent_row(view, 0));
    for (BodyIndex body = 0; body < view.robots.size(); ++body) {
      if (view.robots[body].lives()) file_.write(agent_row(view, body), view.web);
    }
    file_.flush();
  }

  void persist(Archive& archive) {
    archive(every_ticks_, file_);
    Archive::require(every_ticks_ >= 1, "agents.csv at every 0th tick");
  }
  [[nodiscard]] TableSum sum() const { return file_.sum(); }
  [[nodiscard]] std::int64_t every_ticks() const { return every_ticks_; }

 private:
  static std::int64_t checked(std::int64_t every_ticks) {
    if (every_ticks >= 1) return every_ticks;
    throw std::invalid_argument{"agents_every_ticks = " + std::to_string(every_ticks) + ": must be >= 1"};
  }

  std::int64_t every_ticks_;
  CsvFile<AgentRow> file_;
};

}  // namespace trophic::io
