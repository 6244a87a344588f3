// SPDX-License-Identifier: MIT
// The text of --help by CLI11, for command_parser.hpp.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <tools/command/option.hpp>

namespace trophic::command::detail {

[[nodiscard]] inline std::shared_ptr<CLI::Formatter> help_formatter() {
  auto formatter = std::make_shared<CLI::Formatter>();
  formatter->column_width(26);
  formatter->label("Positionals", "Arguments");
  formatter->label("SUBCOMMAND", "COMMAND");
  return formatter;
}

/// The end of --help: commands elsewhere, exit codes, then examples.
[[nodiscard]] inline std::string footer_of(const Command& command) {
  std::string text;
  for (const std::string& name : command.elsewhere)
    text += (text.empty() ? "Further commands, each with its own --help: " : ", ") + name;
  text += text.empty() ? "" : "\n\n";
  text +=
      "Exit codes: 0 done; 1 a run or a computation failed; 2 wrong arguments, nothing was started; 3 interrupted by a signal";
  for (const std::string& example : command.examples) {
    text += (&example == command.examples.data() ? "\n\nExamples:\n  " : "\n  ") + example;
  }
  return text;
}

}  // namespace trophic::command::detail
