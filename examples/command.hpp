// SPDX-License-Identifier: MIT
// What the main functions of the examples have in common: arguments in, exit code and one line about what went wrong out.
#pragma once

#include <CLI/CLI.hpp>
#include <exception>
#include <functional>
#include <iostream>
#include <stdexcept>
#include <string>

namespace trophic::examples {

/// Exit codes: what could be known from the arguments, and what went wrong later.
inline constexpr int usage_error = 2;
inline constexpr int run_error = 1;

/// The command as it was typed, words separated by blanks.
[[nodiscard]] inline std::string command_line(int argc, char** argv) {
  std::string line;
  for (int i = 0; i < argc; ++i) line += (i == 0 ? "" : " ") + std::string{argv[i]};
  return line;
}

/// Reads the arguments and returns the exit code of `work`, or that of what it threw.
[[nodiscard]] inline int run_command(CLI::App& app, int argc, char** argv, const std::string& name,
                                     const std::function<int()>& work) {
  const auto report = [&](const std::exception& error, int code) {
    std::cerr << name << ": " << error.what() << "\n";
    return code;
  };
  try {
    app.parse(argc, argv);
    return work();
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : usage_error;
  } catch (const std::invalid_argument& error) {
    return report(error, usage_error);
  } catch (const std::exception& error) {
    return report(error, run_error);
  }
}

}  // namespace trophic::examples
