// SPDX-License-Identifier: MIT
// How much memory a program takes.
#pragma once

#include <unistd.h>

#include <fstream>
#include <string>
#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace trophic::test {

/// Bytes of memory that the process holds now.
inline double resident_bytes() {
  std::ifstream file{"/proc/self/statm"};
  double total_pages = 0.0;
  double resident_pages = 0.0;
  file >> total_pages >> resident_pages;
  return resident_pages * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

/// The most bytes of memory that the process held since `forget_peak`, or since its start.
inline double peak_bytes() {
  std::ifstream file{"/proc/self/status"};
  for (std::string word; file >> word;) {
    double kilobytes = 0.0;
    if (word == "VmHWM:" && file >> kilobytes) return 1024.0 * kilobytes;
  }
  return 0.0;
}
inline void forget_peak() {
  std::ofstream{"/proc/self/clear_refs"} << 5;
}

/// Bytes that were asked of glibc and not given back, whether or not they were ever touched; 0 with another library.
inline double allocated_bytes() {
#if defined(__GLIBC__)
  const struct mallinfo2 info = ::mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
#else
  return 0.0;
#endif
}

}  // namespace trophic::test
