// SPDX-License-Identifier: MIT
// From the arguments of main to an exit code: reads the options of a command, calls it, and says in one line what went wrong.
#pragma once

#include <exception>
#include <string>
#include <trophic/command/option.hpp>
#include <trophic/support/linkage.hpp>

namespace trophic::command {

/// The name by which a program was called, without folders.
[[nodiscard]] std::string program_name(const char* called);

/// The command as it was typed, words separated by blanks.
[[nodiscard]] std::string command_line(int argc, const char* const* argv);

/// What an exception says to a user.
[[nodiscard]] const char* what_of(const std::exception& error);

/// Says what went wrong in one line on standard error and returns `run_error`. Takes no memory, as there may be none.
[[nodiscard]] int report_failure(const char* called, const std::exception& error);

/// What a program does in main: `work`, which returns the exit code, with report_failure for what it throws.
template <class Work>
[[nodiscard]] int guarded(const char* called, Work&& work) {
  try {
    return work();
  } catch (const std::exception& error) {
    return report_failure(called, error);
  }
}

/// Reads the arguments and returns the exit code of the command's work. `--help`, `--version` and `--completion bash` print and
/// return 0. What is wrong with the arguments, and every std::invalid_argument, is one line on standard error and `usage_error`;
/// every other exception `run_error`.
[[nodiscard]] int run_command(int argc, const char* const* argv, const Command& command);

}  // namespace trophic::command

#if TROPHIC_HEADER_ONLY
#include <trophic/command/run_command.ipp>
#endif
