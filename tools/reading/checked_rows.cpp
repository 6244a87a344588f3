// SPDX-License-Identifier: MIT
// Definitions of checked_rows.hpp.
#include <tools/reading/checked_rows.hpp>

namespace trophic::analysis {

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

}  // namespace trophic::analysis
