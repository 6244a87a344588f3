// SPDX-License-Identifier: MIT
// From the arguments of main to an exit code: reads the options of a command, calls it, and says in one line what went wrong.
#pragma once

#include <string>
#include <trophic/command/option.hpp>
#include <trophic/support/linkage.hpp>

namespace trophic::command {

/// The name by which a program was called, without folders.
[[nodiscard]] std::string program_name(const char* called);

/// The command as it was typed, words separated by blanks.
[[nodiscard]] std::string command_line(int argc, const char* const* argv);

/// Reads the arguments and returns the exit code of the command's work. `--help`, `--version` and `--completion bash` print and
/// return 0. What is wrong with the arguments, and every std::invalid_argument, is one line on standard error and `usage_error`;
/// every other exception `run_error`.
[[nodiscard]] int run_command(int argc, const char* const* argv, const Command& command);

}  // namespace trophic::command

#if TROPHIC_HEADER_ONLY
#include <trophic/command/run_command.ipp>
#endif
