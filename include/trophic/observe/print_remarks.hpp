// SPDX-License-Identifier: MIT
// Remarks on a run, printed before it.
#pragma once

#include <iostream>
#include <set>
#include <string>
#include <vector>

namespace trophic::observe {

/// Prints remarks to stderr, each once per program, because replicates, nulls and planned runs share them.
inline void print_remarks(const std::vector<std::string>& remarks) {
  static std::set<std::string> printed;
  for (const std::string& remark : remarks)
    if (printed.insert(remark).second) std::cerr << "remark  " << remark << std::endl;
}

}  // namespace trophic::observe
