// SPDX-License-Identifier: MIT
// A run's folder, read into tables.
#pragma once

#include <map>
#include <tools/reading/csv_reader.hpp>
#include <tools/reading/run_manifest.hpp>
#include <tools/reading/table_reader.hpp>
#include <tools/reading/tables.hpp>

namespace trophic::analysis {

/// A run's manifest and tables. `remarks` say what is left out, and where.
struct RunData {
  RunManifest manifest;
  std::optional<std::vector<EventRow>> events;
  std::optional<std::vector<AgentRow>> agents;
  std::vector<std::string> remarks;
};

namespace detail {

void remark_truncated(const CsvReader& csv, const std::filesystem::path& path, std::vector<std::string>& remarks);

/// Rows and checksum of a table on the disk. Throws std::invalid_argument if it cannot be read.
[[nodiscard]] io::TableSum sum_of(const std::filesystem::path& path);

/// Throws std::invalid_argument if a table is not what the run wrote.
void check_sum(io::TableSum is, const std::filesystem::path& path, io::TableSum was);
void check_sum(const CsvReader& csv, const std::filesystem::path& path, const std::map<std::string, io::TableSum>& sums);

}  // namespace detail

/// Reads an events.csv. Throws std::runtime_error "FILE:LINE: ..."; a truncated last line goes to `remarks`. `sums`: what the
/// tables must be, by file; throws std::invalid_argument for one that is not.
[[nodiscard]] std::vector<EventRow> read_events(const std::filesystem::path& path, const FoodWeb& web,
                                                std::vector<std::string>& remarks,
                                                const std::map<std::string, io::TableSum>& sums = {});

/// Reads an agents.csv. Throws std::runtime_error "FILE:LINE: ..."; the last tick of a truncated file is left out, and
/// `remarks` say so. `sums`: as in read_events. `every_ticks`: what the manifest says of the ticks that it has.
[[nodiscard]] std::vector<AgentRow> read_agents(const std::filesystem::path& path, const FoodWeb& web,
                                                std::vector<std::string>& remarks,
                                                const std::map<std::string, io::TableSum>& sums = {},
                                                std::int64_t every_ticks = 1);

/// Leaves of a run its first `until_s` seconds. Throws std::invalid_argument if it did not last that long.
void cut_to(RunData& run, double until_s);

/// Throws std::invalid_argument naming the first table or recording that is not what the run wrote, by its manifest's checksums.
void check_files(const RunManifest& manifest);

/// Reads a run's folder. Throws std::runtime_error for the manifest, and std::invalid_argument for a table that cannot be read,
/// and for any file that is not what the run wrote. The end of a table that a killed program left is left out and remarked on.
[[nodiscard]] RunData read_run(const std::filesystem::path& folder);

/// Calls `visit(row)` for each row of the table `name` in the run's folder. Throws std::invalid_argument, a sentence that names
/// the file, if it cannot be read, was truncated, or was changed after the run.
template <io::TableRow Row, class Visit>
void for_each_row(const RunManifest& run, const char* name, Visit&& visit) {
  const std::filesystem::path path = run.folder / name;
  try {
    TableReader<Row> table{path, run.web};
    detail::check_sum(table.csv(), path, run.tables);
    for (Row row; table.next(row);) visit(row);
    if (table.csv().truncated()) throw std::invalid_argument{path.string() + ": the last line is truncated; resume the run"};
  } catch (const std::runtime_error& error) {
    throw std::invalid_argument{error.what()};
  }
}

}  // namespace trophic::analysis
