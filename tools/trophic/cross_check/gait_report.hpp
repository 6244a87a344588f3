// SPDX-License-Identifier: MIT
// Gaits under several conditions against MuJoCo's: on the terminal, in the CSV, and paths for the figure.
#pragma once

#include <span>
#include <tools/trophic/cross_check/report.hpp>
#include <tools/trophic/cross_check/walk.hpp>
#include <trophic/io/csv_file.hpp>

namespace trophic::command::cross_check {

/// A condition and what its robots did.
struct Outcome {
  Condition condition;
  std::vector<Walk> walks;
};

[[nodiscard]] std::vector<double> values_of(const Outcome& outcome, const Quantity& quantity);

/// How far apart the robots of two outcomes are after 10 s, m.
[[nodiscard]] std::vector<double> distances_m(const Outcome& a, const Outcome& b);

/// The finest timestep at which the engine walked with its default settings.
[[nodiscard]] const Outcome& finest(std::span<const Outcome> outcomes, std::string_view engine);

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

/// Writes what walks towards one target angle did after those towards another. Differences are judged against MuJoCo's first
/// outcome for the same angle; margins are shares of what MuJoCo's robots do on the first angle of all, on which they turn.
class GaitReport {
 public:
  GaitReport(const std::filesystem::path& folder, Csv& csv);

  /// All outcomes for one target angle, MuJoCo's at its default timestep first.
  void add(std::span<const Outcome> outcomes);

 private:
  static constexpr double smallest_scale = 1e-3;

  void add(const Outcome& outcome, const Outcome& reference, const Outcome& mujoco, const Outcome& own);

  Csv& csv_;
  trophic::io::CsvFile<TrajectoryRow> paths_;
  std::vector<double> scales_;  ///< one per quantity
};

}  // namespace trophic::command::cross_check
