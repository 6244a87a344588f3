// SPDX-License-Identifier: MIT
// Definitions of read_run.hpp.
#include <tools/analysis/data/read_run.hpp>

#include <stdexcept>
#include <tools/analysis/data/table_reader.hpp>
#include <trophic/params/params.hpp>

namespace trophic::analysis::detail {

void remark_truncated(const CsvReader& csv, const std::filesystem::path& path, std::vector<std::string>& remarks) {
  if (!csv.truncated()) return;
  remarks.push_back(path.string() + ":" + std::to_string(csv.line() + 1) +
                    ": cut off in the middle of a line (killed run?); everything before it is used");
}

void check_sum(const CsvReader& csv, const std::filesystem::path& path, const std::map<std::string, io::TableSum>& sums) {
  const auto expected = sums.find(path.filename().string());
  if (expected == sums.end()) return;
  const io::TableSum is = csv.sum();
  const io::TableSum was = expected->second;
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

RunData read_run(const std::filesystem::path& folder) {
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
