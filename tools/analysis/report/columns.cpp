// SPDX-License-Identifier: MIT
// Definitions of columns.hpp.
#include <tools/analysis/report/columns.hpp>

#include <algorithm>
#include <cstddef>
#include <trophic/observe/terminal.hpp>

namespace trophic::analysis {

void Columns::print(std::ostream& out, const std::string& indent) const {
  std::vector<std::size_t> widths;
  for (const auto& row : rows_) {
    if (row.size() == 1) continue;
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], observe::columns_of(row[i]));
  }
  for (const auto& row : rows_) {
    if (row.size() == 1) {
      out << indent << row.front() << "\n";
      continue;
    }
    std::string line = indent;
    for (std::size_t i = 0; i < row.size(); ++i) line += row[i] + std::string(widths[i] - observe::columns_of(row[i]) + 2, ' ');
    line.erase(line.find_last_not_of(' ') + 1);
    out << line << "\n";
  }
}

}  // namespace trophic::analysis
