// SPDX-License-Identifier: MIT
// Rows of cells on the terminal, each column as wide as its widest cell.
#pragma once

#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace trophic::analysis {

/// Columns stand two blanks apart; no line ends with a blank. A row of one cell is a heading, which no column has to hold.
class Columns {
 public:
  explicit Columns(std::vector<std::string> head) { add(std::move(head)); }

  /// Adds a row; cells that it lacks are empty.
  void add(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }
  [[nodiscard]] bool empty() const { return rows_.size() == 1; }
  /// Each line begins with `indent`.
  void print(std::ostream& out, const std::string& indent = "") const;

 private:
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace trophic::analysis
