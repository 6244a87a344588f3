// SPDX-License-Identifier: MIT
// The walks of robots as tables: walks.csv and trajectories.csv.
#pragma once

#include <tools/trophic/cross_check/walk.hpp>
#include <trophic/io/csv_file.hpp>

namespace trophic::command::cross_check {

/// A condition and what its robots did.
struct Outcome {
  Condition condition;
  std::vector<Walk> walks;
};

/// walks.csv: one row per robot and condition.
struct WalkRow {
  std::string engine = {};
  std::string settings = {};
  double timestep_s = 0.0;
  double target_angle_rad = 0.0;
  std::size_t robot = 0;
  double speed_m_s = 0.0;
  double turn_rate_rad_s = 0.0;
  double power_W = 0.0;
  double torque_N_m = 0.0;

  static constexpr auto columns() {
    using trophic::io::column;
    return std::tuple{column("engine", &WalkRow::engine, "", "name of the physics engine"),
                      column("settings", &WalkRow::settings, "", "which parameters of the engine"),
                      column("timestep_s", &WalkRow::timestep_s, "s", "of the engine"),
                      column("target_angle_rad", &WalkRow::target_angle_rad, "rad", "that the robots were steered by"),
                      column("robot", &WalkRow::robot, "", "its number"),
                      column("speed_m_s", &WalkRow::speed_m_s, "m/s", "path between samples 2 s apart, over time"),
                      column("turn_rate_rad_s", &WalkRow::turn_rate_rad_s, "rad/s", "change of the heading, over time"),
                      column("power_W", &WalkRow::power_W, "W", "sum over hinges of abs(torque x velocity), mean over time"),
                      column("torque_N_m", &WalkRow::torque_N_m, "N m", "mean over hinges and time of the servo's abs(torque)")};
  }
};

/// trajectories.csv: where a robot was.
struct TrajectoryRow {
  std::string engine = {};
  std::string settings = {};
  double timestep_s = 0.0;
  double target_angle_rad = 0.0;
  std::size_t robot = 0;
  double time_s = 0.0;
  double x_m = 0.0;
  double y_m = 0.0;
  double heading_rad = 0.0;

  static constexpr auto columns() {
    using trophic::io::column;
    return std::tuple{column("engine", &TrajectoryRow::engine, "", "name of the physics engine"),
                      column("settings", &TrajectoryRow::settings, "", "which parameters of the engine"),
                      column("timestep_s", &TrajectoryRow::timestep_s, "s", "of the engine"),
                      column("target_angle_rad", &TrajectoryRow::target_angle_rad, "rad", "that the robots were steered by"),
                      column("robot", &TrajectoryRow::robot, "", "its number"),
                      column("time_s", &TrajectoryRow::time_s, "s", "since the start"),
                      column("x_m", &TrajectoryRow::x_m, "m", "where it stands"),
                      column("y_m", &TrajectoryRow::y_m, "m", "where it stands"),
                      column("heading_rad", &TrajectoryRow::heading_rad, "rad", "counter-clockwise from x")};
  }
};

class WalkTables {
 public:
  explicit WalkTables(const std::filesystem::path& folder) : walks_{folder / "walks.csv"}, paths_{folder / "trajectories.csv"} {}

  void write(const Outcome& outcome);

 private:
  io::CsvFile<WalkRow> walks_;
  io::CsvFile<TrajectoryRow> paths_;
};

}  // namespace trophic::command::cross_check
