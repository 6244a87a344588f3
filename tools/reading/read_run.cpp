// SPDX-License-Identifier: MIT
// Definitions of read_run.hpp.
#include <tools/reading/read_run.hpp>

#include <fstream>
#include <trophic/support/checksum.hpp>
#include <trophic/support/whole_file.hpp>

namespace trophic::analysis::detail {

void remark_truncated(const CsvReader& csv, const std::filesystem::path& path, std::vector<std::string>& remarks) {
  if (!csv.truncated()) return;
  remarks.push_back(path.string() + ":" + std::to_string(csv.line() + 1) +
                    ": truncated in the middle of a line (killed run?); everything before it is used");
}

/// A run's last tick may end after its duration, by less than the longest tick.
bool is_time(double time_s) {
  constexpr double longest_tick_s = 3600.0;
  return time_s >= 0.0 && time_s <= most_time_s + longest_tick_s;
}
std::string time_bound() {
  return ">= 0 and <= " + number_text(most_time_s);
}

io::TableSum sum_of(const std::filesystem::path& path) {
  static_cast<void>(read_beginning(path, 0));  // says what is wrong; opening a pipe would wait
  std::ifstream file{path, std::ios::binary};
  std::array<char, 1U << 16U> piece;
  std::uint64_t lines = 0;
  std::uint32_t crc32 = 0;
  while (file) {
    file.read(piece.data(), piece.size());
    const std::string_view got{piece.data(), static_cast<std::size_t>(file.gcount())};
    lines += static_cast<std::uint64_t>(std::ranges::count(got, '\n'));
    crc32 = checksum(got, crc32);
  }
  return {.rows = lines == 0 ? 0 : lines - 1, .crc32 = crc32};
}

void check_sum(const CsvReader& csv, const std::filesystem::path& path, const std::map<std::string, io::TableSum>& sums) {
  const auto expected = sums.find(path.filename().string());
  if (expected != sums.end()) check_sum(csv.sum(), path, expected->second);
}

void check_sum(io::TableSum is, const std::filesystem::path& path, io::TableSum was) {
  if (is.rows == was.rows && is.crc32 == was.crc32) return;
  throw std::invalid_argument{path.string() + ": has " + std::to_string(is.rows) + " rows and checksum " +
                              std::to_string(is.crc32) + ": must be " + std::to_string(was.rows) + " and " +
                              std::to_string(was.crc32) + ", as its manifest says; the table was cut or changed after the run"};
}

}  // namespace trophic::analysis::detail

namespace trophic::analysis {

std::vector<EventRow> read_events(const std::filesystem::path& path, const FoodWeb& web, std::vector<std::string>& remarks,
                                  const std::map<std::string, io::TableSum>& sums) {
  TableReader<EventRow> table{path, web};
  detail::check_sum(table.csv(), path, sums);
  std::vector<EventRow> rows;
  for (EventRow row; table.next(row);) {
    if (!rows.empty() && row.tick < rows.back().tick) table.reject("tick", ">= that of the row before");
    if (!detail::is_time(row.time_s)) table.reject("time_s", detail::time_bound());
    rows.push_back(row);
  }
  detail::remark_truncated(table.csv(), path, remarks);
  return rows;
}

std::vector<AgentRow> read_agents(const std::filesystem::path& path, const FoodWeb& web, std::vector<std::string>& remarks,
                                  const std::map<std::string, io::TableSum>& sums, std::int64_t every_ticks) {
  TableReader<AgentRow> table{path, web};
  detail::check_sum(table.csv(), path, sums);
  std::vector<AgentRow> rows;
  for (AgentRow row; table.next(row);) {
    if (row.tick % every_ticks != 0)
      table.reject("tick", "a multiple of " + std::to_string(every_ticks) + ", as its manifest says");
    if (!rows.empty() && row.tick < rows.back().tick) table.reject("tick", ">= that of the row before");
    if (!detail::is_time(row.time_s)) table.reject("time_s", detail::time_bound());
    rows.push_back(row);
  }
  detail::remark_truncated(table.csv(), path, remarks);
  if (table.csv().truncated() && !rows.empty()) {
    const std::int64_t last = rows.back().tick;
    std::erase_if(rows, [&](const AgentRow& row) { return row.tick == last; });
  }
  return rows;
}

void cut_to(RunData& run, double until_s) {
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

void check_files(const RunManifest& manifest) {
  for (const auto& [name, was] : manifest.tables) {
    if (std::filesystem::path{name}.has_parent_path()) {
      throw std::invalid_argument{(manifest.folder / "manifest.json").string() + ": tables: " + name +
                                  ": must be the name of a file"};
    }
    detail::check_sum(detail::sum_of(manifest.folder / name), manifest.folder / name, was);
  }
  if (!manifest.recording_crc32) return;
  const std::filesystem::path path = manifest.folder / "replay.trp";
  const std::uint32_t is = detail::sum_of(path).crc32;
  if (is == *manifest.recording_crc32) return;
  throw std::invalid_argument{path.string() + ": has checksum " + std::to_string(is) + ": must be " +
                              std::to_string(*manifest.recording_crc32) +
                              ", as its manifest says; the recording was cut or changed after the run"};
}

RunData read_run(const std::filesystem::path& folder) {
  RunData run{.manifest = read_manifest(folder), .events = {}, .agents = {}, .remarks = {}};
  check_files(run.manifest);
  if (run.manifest.status != "complete") {
    run.remarks.push_back((folder / "manifest.json").string() + ": status \"" + run.manifest.status +
                          "\": the run did not reach its end");
  }
  try {
    run.events = read_events(folder / "events.csv", run.manifest.web, run.remarks, run.manifest.tables);
    run.agents =
        read_agents(folder / "agents.csv", run.manifest.web, run.remarks, run.manifest.tables, run.manifest.agents_every_ticks);
  } catch (const std::runtime_error& error) {
    throw std::invalid_argument{error.what()};
  }
  return run;
}

}  // namespace trophic::analysis
