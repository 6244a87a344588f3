// SPDX-License-Identifier: MIT
// Converts the arguments of main to an exit code: reads the options of a command, calls it, and prints errors on one line.
#pragma once

#include <exception>
#include <tools/command/option.hpp>

namespace trophic::command {

/// The name with which a program was called, without folders.
[[nodiscard]] std::string program_name(const char* called);

/// The command as it was typed, with words separated by spaces.
[[nodiscard]] std::string command_line(int argc, const char* const* argv);

/// The text of an exception for users.
[[nodiscard]] const char* what_of(const std::exception& error);

/// Prints the error in one line on standard error and returns `run_error`. Allocates no memory, because there may be none.
[[nodiscard]] int report_failure(const char* called, const std::exception& error);

/// Calls `work`, which returns the exit code, and report_failure for exceptions: the body of a program's main.
template <class Work>
[[nodiscard]] int guarded(const char* called, Work&& work) {
  try {
    return work();
  } catch (const std::exception& error) {
    return report_failure(called, error);
  }
}

/// Reads the arguments and returns the exit code of the command's work. `--help` and `--version` print and return 0. Wrong
/// arguments, and every std::invalid_argument, give one line on standard error and `usage_error`; every other exception gives
/// `run_error`.
[[nodiscard]] int run_command(int argc, const char* const* argv, const Command& command);

}  // namespace trophic::command
