// SPDX-License-Identifier: MIT
// Definitions of recorded_agents.hpp.
#include <tools/trophic/replay/recorded_agents.hpp>

#include <cmath>
#include <tools/reading/table_reader.hpp>
#include <trophic/population/food_web.hpp>

namespace trophic::command::replay {

RecordedAgents::RecordedAgents(const RecordedRun& run, double from_s, double to_s, double before_s)
    : tick_s_{run.recording.head().times.tick_s}, robots_{run.recording.head().robots} {
  const FoodWeb web{run.recording.head().species, {}};
  const std::filesystem::path path = run.folder / "agents.csv";
  try {
    analysis::TableReader<io::AgentRow> reader{path, web};
    io::AgentRow row;
    while (reader.next(row)) {
      if (row.time_s < from_s - before_s - tick_s_ || row.time_s > to_s + 1e-9) continue;
      if (rows_.empty()) first_tick_ = row.tick;
      const auto expected = static_cast<std::size_t>(row.tick - first_tick_) * robots_ + row.body;
      if (rows_.size() != expected || row.body >= robots_) {
        throw std::invalid_argument{path.string() + ":" + std::to_string(reader.csv().line()) + ": must be a row for each of " +
                                    std::to_string(robots_) + " bodies at every tick"};
      }
      rows_.push_back(row);
    }
  } catch (const std::runtime_error& error) {
    throw std::invalid_argument{error.what()};
  }
  rows_.resize(rows_.size() / robots_ * robots_);
  if (rows_.empty()) throw std::invalid_argument{path.string() + ": has no row of the time to be shown"};
}

std::span<const io::AgentRow> RecordedAgents::at(double time_s) const {
  const auto last = static_cast<std::int64_t>(rows_.size() / robots_) - 1;
  const auto tick = static_cast<std::int64_t>(std::floor(time_s / tick_s_ + 1e-9)) - first_tick_;
  const auto place = static_cast<std::size_t>(std::clamp<std::int64_t>(tick, 0, last));
  return std::span{rows_}.subspan(place * robots_, robots_);
}

}  // namespace trophic::command::replay
