// SPDX-License-Identifier: MIT
// The rows of a table that is as the run wrote it.
#pragma once

#include <tools/reading/run_manifest.hpp>
#include <tools/reading/table_reader.hpp>

namespace trophic::analysis {

/// Throws std::invalid_argument if a table is not what the run wrote; `sums`: what the tables must be, by file.
void check_sum(const CsvReader& csv, const std::filesystem::path& path, const std::map<std::string, io::TableSum>& sums);

/// Calls `visit(row)` for each row of the table `name` in the run's folder. Throws std::invalid_argument, a sentence that names
/// the file, if it cannot be read, was truncated, or was changed after the run.
template <io::TableRow Row, class Visit>
void for_each_row(const RunManifest& run, const char* name, Visit&& visit) {
  const std::filesystem::path path = run.folder / name;
  try {
    TableReader<Row> table{path, run.web};
    check_sum(table.csv(), path, run.tables);
    for (Row row; table.next(row);) visit(row);
    if (table.csv().truncated()) throw std::invalid_argument{path.string() + ": the last line is truncated; resume the run"};
  } catch (const std::runtime_error& error) {
    throw std::invalid_argument{error.what()};
  }
}

}  // namespace trophic::analysis
