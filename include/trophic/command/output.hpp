// SPDX-License-Identifier: MIT
// What a program prints either arrives or is an error.
#pragma once

#include <iostream>
#include <stdexcept>
#include <string>

namespace trophic::command {

/// Hands standard output to the system. Throws std::runtime_error where it does not take it.
inline void flush_output() {
  std::cout.flush();
  if (!std::cout) throw std::runtime_error{"cannot write to standard output"};
}

/// Prints a text and returns 0, the exit code of a command that does no more.
[[nodiscard]] inline int print_text(const std::string& text) {
  std::cout << text;
  flush_output();
  return 0;
}

}  // namespace trophic::command
