// SPDX-License-Identifier: MIT
// A table of results that has its name only once it is whole.
#pragma once

#include <filesystem>
#include <trophic/io/column.hpp>
#include <trophic/io/csv.hpp>
#include <trophic/support/new_file.hpp>

namespace trophic::analysis {

/// Rows without species, in a new file that is "PATH.part" until `finish`; without it nothing is left. Throws std::runtime_error
/// naming the file if it exists or cannot be written.
template <io::TableRow Row>
class TableFile {
 public:
  explicit TableFile(const std::filesystem::path& path) : file_{path}, rows_{io::header_of<Row>()} {}

  void write(const Row& row) { io::append_row(rows_, row, no_species_); }
  /// Hands the rows written so far to the system, so that they need not be kept.
  void flush() {
    file_.write(rows_);
    rows_.clear();
  }
  void finish() {
    flush();
    file_.finish();
  }

 private:
  FoodWeb no_species_{{}, {}};
  NewFile file_;
  std::string rows_;
};

}  // namespace trophic::analysis
