// SPDX-License-Identifier: MIT
// The rows of a table of a run whose manifest was read, and with it the checksums of its tables.
#pragma once

#include <tools/reading/run_manifest.hpp>
#include <tools/reading/table_reader.hpp>

namespace trophic::analysis {

/// Calls `visit(row)` for each row of the table `name` in the run's folder. Throws std::invalid_argument, a sentence that names
/// the file, if it cannot be read or was truncated.
template <io::TableRow Row, class Visit>
void for_each_row(const RunManifest& run, const char* name, Visit&& visit) {
  const std::filesystem::path path = run.folder / name;
  try {
    TableReader<Row> table{path, run.web};
    for (Row row; table.next(row);) visit(row);
    if (table.csv().truncated()) throw std::invalid_argument{path.string() + ": the last line is truncated; resume the run"};
  } catch (const std::runtime_error& error) {
    throw std::invalid_argument{error.what()};
  }
}

}  // namespace trophic::analysis
