// SPDX-License-Identifier: MIT
// Individuals and their tags, by body, at every tick of a stretch of a run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <tools/trophic/replay/recorded_run.hpp>
#include <trophic/io/tables.hpp>
#include <vector>

namespace trophic::command::replay {

/// Rows of agents.csv, found by tick and body.
class RecordedAgents {
 public:
  /// Reads the ticks that begin in [from_s - before_s, to_s]. Throws std::invalid_argument for a table that is not the run's.
  RecordedAgents(const RecordedRun& run, double from_s, double to_s, double before_s);

  /// The rows of agents.csv at a moment, by body.
  [[nodiscard]] std::span<const io::AgentRow> at(double time_s) const;

 private:
  double tick_s_;
  std::size_t robots_;
  std::int64_t first_tick_ = 0;
  std::vector<io::AgentRow> rows_;
};

}  // namespace trophic::command::replay
