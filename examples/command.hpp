// SPDX-License-Identifier: MIT
// What the main functions of the examples have in common: arguments in, exit code and one line about what went wrong out.
#pragma once

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdint>
#include <exception>
#include <functional>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

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

/// Throws std::invalid_argument "--seed -1: must be >= 0" for what CLI11 would take for another number: -1 is 2^64 - 1 to it, 010
/// is 8.
inline void check_whole_number(const std::string& option, const std::string& text) {
  const auto refuse = [&](const std::string& must) { throw std::invalid_argument{option + " " + text + ": must be " + must}; };
  const auto all_digits = [](std::string_view digits) {
    return !digits.empty() && digits.find_first_not_of("0123456789") == std::string_view::npos;
  };
  if (text.starts_with('-') && all_digits(std::string_view{text}.substr(1))) refuse(">= 0");
  if (!all_digits(text) || (text.size() > 1 && text.front() == '0')) refuse("a whole number in decimal digits");
  std::uint64_t value = 0;
  if (std::from_chars(text.data(), text.data() + text.size(), value).ec != std::errc{}) {
    refuse("<= " + std::to_string(std::numeric_limits<std::uint64_t>::max()));
  }
}

/// Every option that takes an unsigned number takes one that was meant as such.
inline void check_whole_numbers(CLI::App& app) {
  for (CLI::Option* option : app.get_options()) {
    if (option->get_type_name() != "UINT") continue;
    option->check([name = option->get_name()](const std::string& text) {
      check_whole_number(name, text);
      return std::string{};
    });
  }
}

/// Reads the arguments and returns the exit code of `work`, or that of what it threw.
[[nodiscard]] inline int run_command(CLI::App& app, int argc, char** argv, const std::string& name,
                                     const std::function<int()>& work) {
  const auto report = [&](const std::exception& error, int code) {
    std::cerr << name << ": " << error.what() << "\n";
    return code;
  };
  try {
    check_whole_numbers(app);
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
