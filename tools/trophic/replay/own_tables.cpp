// SPDX-License-Identifier: MIT
// Definitions of own_tables.hpp.
#include <tools/trophic/replay/own_tables.hpp>

#include <Eigen/Core>
#include <cmath>
#include <map>
#include <tools/reading/csv_reader.hpp>

namespace trophic::command::replay {

namespace {

/// Holds the rows of a run's tables to its recording. The recording of a killed run may lack the last moments.
class OwnTables {
 public:
  OwnTables(std::filesystem::path folder, const io::RecordingReader& recording)
      : folder_{std::move(folder)}, recording_{recording}, last_s_{recording.time_s(recording.frames() - 1)} {}

  /// Throws std::invalid_argument unless every event of events.csv happened at a tick of the recording, to an individual that was
  /// born into that body and lived there until then; std::runtime_error for a file that cannot be read.
  void check_events() {
    analysis::CsvReader events{folder_ / "events.csv", {"time_s", "tick", "body", "x_m", "y_m", "id", "event"}};
    std::vector<std::optional<std::uint64_t>> lives(recording_.head().robots);
    while (events.next()) {
      const bool is_birth = events.text(6) == "birth";
      const auto id = events.get<std::uint64_t>(5);
      if (is_birth) births_[id] = {events.get<std::size_t>(2), events.get<std::int64_t>(1)};
      const Row row = row_of(events, "events.csv");
      if (is_birth) {
        lives[row.body] = id;
      } else if (lives[row.body] != id && is_from_birth()) {
        throw std::invalid_argument{row.where + ": robot " + std::to_string(id) +
                                    " was never born there; they belong to different runs"};
      }
    }
  }

  /// The same of agents.csv, after `check_events`.
  void check_agents() const {
    analysis::CsvReader agents{folder_ / "agents.csv", {"time_s", "tick", "body", "x_m", "y_m", "id"}};
    while (agents.next()) {
      const Row row = row_of(agents, "agents.csv");
      check_born(agents.get<std::uint64_t>(5), row.body, row.where);
    }
  }

  /// Throws std::invalid_argument unless each individual in phylogeny.csv was born into the body that events.csv has.
  void check_phylogeny() const {
    analysis::CsvReader taxa{folder_ / "phylogeny.csv", {"id", "body"}};
    while (taxa.next()) check_born(taxa.get<std::uint64_t>(0), taxa.get<std::size_t>(1), place_of(taxa, "phylogeny.csv"));
  }

  /// Throws std::invalid_argument unless each row of senses.csv is of the robot in the same row of agents.csv, as far as both go.
  void check_senses() const {
    analysis::CsvReader agents{folder_ / "agents.csv", {"time_s", "tick", "body", "id"}};
    analysis::CsvReader senses{folder_ / "senses.csv", {"time_s", "tick", "body", "id"}};
    while (agents.next() && senses.next()) {
      for (std::size_t cell = 0; cell < 4; ++cell) {
        if (senses.text(cell) == agents.text(cell)) continue;
        throw std::invalid_argument{place_of(senses, "senses.csv") +
                                    ": is not of the robot and tick in that row of agents.csv; they belong to different runs"};
      }
    }
  }

 private:
  struct Row {
    std::size_t body = 0;
    std::string where;
  };

  [[nodiscard]] std::string place_of(const analysis::CsvReader& csv, const char* table) const {
    return (folder_ / table).string() + ":" + std::to_string(csv.line());
  }

  /// The row at hand, whose first columns are time_s, tick, body, x_m, y_m and id, held to the recording.
  [[nodiscard]] Row row_of(const analysis::CsvReader& csv, const char* table) const {
    const auto time_s = csv.get<double>(0);
    const auto tick = csv.get<std::int64_t>(1);
    const auto body = csv.get<std::size_t>(2);
    const auto& head = recording_.head();
    std::string where = place_of(csv, table) + ": body " + std::to_string(body) + " at " + number_text(time_s) + " s";
    if (body >= head.robots) {
      throw std::invalid_argument{where + ": the recording next to it has " + std::to_string(head.robots) + " bodies"};
    }
    if (std::abs(time_s - static_cast<double>(tick) * head.times.tick_s) > 1e-6) {
      throw std::invalid_argument{where + ": must be at " + number_text(static_cast<double>(tick) * head.times.tick_s) +
                                  " s, tick " + std::to_string(tick) + " of the recording next to it"};
    }
    if (time_s > last_s_ + 1e-9) {
      if (!recording_.remark().empty()) return {body, std::move(where)};
      throw std::invalid_argument{where + ": the recording next to it ends at " + number_text(last_s_) + " s"};
    }
    if (time_s < head.first_time_s) return {body, std::move(where)};
    const std::size_t frame = recording_.frame_at(std::min(time_s + 1e-9, last_s_));
    const auto id = csv.get<std::uint64_t>(5);
    const auto birth = births_.find(id);
    const bool is_founder = tick == 0 && id == body;
    const bool is_born = birth != births_.end() && birth->second.second == tick && !is_founder;
    if (recording_.is_set_down(frame + 1, body) || is_born) {
      return {body, std::move(where)};  // a newborn's place, which later frames have
    }
    const Eigen::Vector3d at = recording_.root(frame, body).position_m;
    const double x_m = csv.get<double>(3);
    const double y_m = csv.get<double>(4);
    if (std::hypot(at.x() - x_m, at.y() - y_m) > 0.002 + head.units.position_m) {
      throw std::invalid_argument{where + " is at (" + number_text(x_m) + ", " + number_text(y_m) +
                                  ") m, in the recording next to it elsewhere; they belong to different runs"};
    }
    return {body, std::move(where)};
  }

  /// Whether the recording begins with the founders' births. A program of one's own may begin it later.
  [[nodiscard]] bool is_from_birth() const { return recording_.head().first_time_s <= 0.0; }

  void check_born(std::uint64_t id, std::size_t body, const std::string& where) const {
    const auto birth = births_.find(id);
    if (!is_from_birth() || (birth != births_.end() && birth->second.first == body)) return;
    throw std::invalid_argument{where + ": robot " + std::to_string(id) + " was never born into body " + std::to_string(body) +
                                " by the events.csv next to it; they belong to different runs"};
  }

  std::filesystem::path folder_;
  const io::RecordingReader& recording_;
  double last_s_;
  std::map<std::uint64_t, std::pair<std::size_t, std::int64_t>> births_;  ///< by individual: body and tick
};

}  // namespace

void check_own_tables(const std::filesystem::path& folder, const io::RecordingReader& recording, const Json& manifest) {
  OwnTables tables{folder, recording};
  tables.check_events();
  const Json sums = manifest.value("tables", Json::object());
  const bool has_senses = std::filesystem::exists(folder / "senses.csv");
  if (!sums.contains("agents.csv")) tables.check_agents();
  if (!sums.contains("phylogeny.csv")) tables.check_phylogeny();
  if (has_senses && !sums.contains("senses.csv")) tables.check_senses();
}

}  // namespace trophic::command::replay
