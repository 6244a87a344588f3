// SPDX-License-Identifier: MIT
// How much memory a program takes.
#pragma once

#include <unistd.h>

#include <fstream>

namespace trophic::test {

/// Bytes of memory that the process holds now.
inline double resident_bytes() {
  std::ifstream file{"/proc/self/statm"};
  double total_pages = 0.0;
  double resident_pages = 0.0;
  file >> total_pages >> resident_pages;
  return resident_pages * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

}  // namespace trophic::test
