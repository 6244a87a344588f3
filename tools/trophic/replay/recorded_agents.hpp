// SPDX-License-Identifier: MIT
// Individuals and their tags at every tick of a stretch of a run, and the food on its floor.
#pragma once

#include <cstddef>
#include <cstdint>
#include <tools/film/picture.hpp>
#include <tools/trophic/replay/recorded_run.hpp>
#include <trophic/io/tables.hpp>
#include <vector>

namespace trophic::command::replay {

/// Rows of agents.csv, found by tick and body. A body without a row is spare.
class RecordedAgents {
 public:
  /// Reads the ticks that begin in [from_s - before_s, to_s]. Throws std::invalid_argument for a table that is not the run's.
  RecordedAgents(const RecordedRun& run, double from_s, double to_s, double before_s);

  /// The rows of agents.csv at a moment, in the order of bodies.
  [[nodiscard]] std::span<const io::AgentRow> at(double time_s) const;
  /// The row of a body at a moment; null if it is spare.
  [[nodiscard]] const io::AgentRow* find(double time_s, std::size_t body) const;
  /// The pose at a frame of who has a row at its moment; at the tick of its birth its body may be elsewhere in the recording.
  [[nodiscard]] Pose root(const io::RecordingReader& recording, std::size_t frame, const io::AgentRow& row) const;

 private:
  double tick_s_;
  std::int64_t first_tick_ = 0;
  std::vector<io::AgentRow> rows_;
  std::vector<std::size_t> begins_;  ///< of each tick in the rows; then their number
};

/// The foods on the floor, as parts of the most that a cell has in the run.
class RecordedFood {
 public:
  /// Throws std::runtime_error for a field.csv that cannot be read.
  explicit RecordedFood(const RecordedRun& run);

  /// Interpolated, in at most a hundred tiles in a row; none in a run without a resource.
  [[nodiscard]] std::vector<film::FoodTile> at(double time_s) const;
  /// The names of the foods; "food" for the only one of a table that names none.
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }

 private:
  using Cells = std::vector<float>;  ///< J in each cell, row by row from the least x and y

  [[nodiscard]] std::size_t place_of(std::string_view name);

  double half_side_m_;
  std::vector<std::string> names_;
  std::vector<float> most_;                                     ///< of each food
  std::vector<std::pair<double, std::vector<Cells>>> moments_;  ///< the cells of each food
};

}  // namespace trophic::command::replay
