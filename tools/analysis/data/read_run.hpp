// SPDX-License-Identifier: MIT
// A run's folder, read into tables.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <tools/analysis/data/csv_reader.hpp>
#include <tools/analysis/data/run_manifest.hpp>
#include <tools/analysis/data/table_reader.hpp>
#include <tools/analysis/data/tables.hpp>
#include <trophic/params/params.hpp>
#include <trophic/population/food_web.hpp>
#include <vector>

namespace trophic::analysis {

/// A run's manifest and tables. A table that could not be read is missing; `remarks` say what was wrong, and where.
struct RunData {
  RunManifest manifest;
  std::optional<std::vector<EventRow>> events;
  std::optional<std::vector<AgentRow>> agents;
  std::vector<std::string> remarks;
};

namespace detail {

inline void remark_truncated(const CsvReader& csv, const std::filesystem::path& path, std::vector<std::string>& remarks) {
  if (!csv.truncated()) return;
  remarks.push_back(path.string() + ":" + std::to_string(csv.line() + 1) +
                    ": cut off in the middle of a line (killed run?); everything before it is used");
}

/// Throws std::invalid_argument if a table is not what the run wrote.
inline void check_sum(const CsvReader& csv, const std::filesystem::path& path,
                      const std::map<std::string, observe::TableSum>& sums) {
  const auto expected = sums.find(path.filename().string());
  if (expected == sums.end()) return;
  const observe::TableSum is = csv.sum();
  const observe::TableSum was = expected->second;
  if (is.rows == was.rows && is.crc32 == was.crc32) return;
  throw std::invalid_argument{path.string() + ": has " + std::to_string(is.rows) + " rows and checksum " +
                              std::to_string(is.crc32) + ": must be " + std::to_string(was.rows) + " and " +
                              std::to_string(was.crc32) + ", as its manifest says; the table was cut or changed after the run"};
}

}  // namespace detail

/// Reads an events.csv. Throws std::runtime_error "FILE:LINE: ..."; a truncated last line goes to `remarks`. `sums`: what the
/// tables must be, by file; throws std::invalid_argument for one that is not.
[[nodiscard]] inline std::vector<EventRow> read_events(const std::filesystem::path& path, const FoodWeb& web,
                                                       std::vector<std::string>& remarks,
                                                       const std::map<std::string, observe::TableSum>& sums = {}) {
  TableReader<EventRow> table{path, web};
  detail::check_sum(table.csv(), path, sums);
  std::vector<EventRow> rows;
  for (EventRow row; table.next(row);) {
    if (!rows.empty() && row.tick < rows.back().tick) table.reject("tick", ">= that of the row before");
    rows.push_back(row);
  }
  detail::remark_truncated(table.csv(), path, remarks);
  return rows;
}

/// Reads an agents.csv. Throws std::runtime_error "FILE:LINE: ..."; of a file that was cut off the last tick is left out, and
/// `remarks` say so. `sums`: as in read_events. `every_ticks`: what the manifest says of the ticks that it has.
[[nodiscard]] inline std::vector<AgentRow> read_agents(const std::filesystem::path& path, const FoodWeb& web,
                                                       std::vector<std::string>& remarks,
                                                       const std::map<std::string, observe::TableSum>& sums = {},
                                                       std::int64_t every_ticks = 1) {
  TableReader<AgentRow> table{path, web};
  detail::check_sum(table.csv(), path, sums);
  std::vector<AgentRow> rows;
  for (AgentRow row; table.next(row);) {
    if (row.tick % every_ticks != 0)
      table.reject("tick", "a multiple of " + std::to_string(every_ticks) + ", as its manifest says");
    if (!rows.empty() && row.tick < rows.back().tick) table.reject("tick", ">= that of the row before");
    rows.push_back(row);
  }
  detail::remark_truncated(table.csv(), path, remarks);
  if (table.csv().truncated() && !rows.empty()) {
    const std::int64_t last = rows.back().tick;
    std::erase_if(rows, [&](const AgentRow& row) { return row.tick == last; });
  }
  return rows;
}

/// Leaves of a run its first `until_s` seconds. Throws std::invalid_argument if it did not last that long.
inline void cut_to(RunData& run, double until_s) {
  const double last_s = run.agents && !run.agents->empty() ? run.agents->back().time_s : 0.0;
  const double reached_s = run.manifest.reached_s.value_or(last_s);
  if (reached_s < until_s) {
    throw std::invalid_argument{run.manifest.folder.string() + ": reached " + number_text(reached_s) + " s (status " +
                                run.manifest.status + "): must be >= " + number_text(until_s) + " s, as --until asks"};
  }
  const auto is_later = [&](const auto& row) { return row.time_s > until_s; };
  if (run.events) std::erase_if(*run.events, is_later);
  if (run.agents) std::erase_if(*run.agents, is_later);
  run.manifest.until_s = until_s;
}

/// Reads a run's folder. Throws std::runtime_error for the manifest, without which nothing can be understood, and
/// std::invalid_argument for a table that is another than the run wrote. What else is missing or broken is left out and remarked
/// on.
[[nodiscard]] inline RunData read_run(const std::filesystem::path& folder) {
  RunData run{.manifest = read_manifest(folder), .events = {}, .agents = {}, .remarks = {}};
  if (run.manifest.status != "complete") {
    run.remarks.push_back((folder / "manifest.json").string() + ": status \"" + run.manifest.status +
                          "\": the run did not reach its end");
  }
  const auto attempt = [&](auto&& read) {
    try {
      read();
    } catch (const std::runtime_error& error) {
      run.remarks.push_back(error.what());
    }
  };
  attempt([&] { run.events = read_events(folder / "events.csv", run.manifest.web, run.remarks, run.manifest.tables); });
  attempt([&] {
    run.agents =
        read_agents(folder / "agents.csv", run.manifest.web, run.remarks, run.manifest.tables, run.manifest.agents_every_ticks);
  });
  return run;
}

}  // namespace trophic::analysis
