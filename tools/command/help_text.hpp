// SPDX-License-Identifier: MIT
// The text of --help, for command_parser.ipp.
#pragma once

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <tools/command/option.hpp>
#include <trophic/observe/terminal.hpp>
#include <utility>
#include <vector>

namespace trophic::command::detail {

/// A text in lines of at most `width` columns; each line after the first begins with `indent` blanks.
[[nodiscard]] inline std::string wrapped(std::string_view text, std::size_t indent, std::size_t width) {
  std::string lines;
  std::size_t column = indent;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(text.size(), word.size() + 1));
    if (column > indent && column + 1 + word.size() > width) {
      lines += "\n" + std::string(indent, ' ');
      column = indent;
    } else if (column > indent) {
      lines += ' ';
      ++column;
    }
    lines += word;
    column += word.size();
  }
  return lines;
}

/// --help as wide as the terminal, and no wider than 110 columns.
class HelpText : public CLI::Formatter {
 public:
  HelpText() {
    label("Positionals", "Arguments");
    label("SUBCOMMAND", "COMMAND");
  }
  std::string make_description(const CLI::App* app) const override { return wrapped(app->get_description(), 0, width_) + "\n"; }
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override {
    std::string text = CLI::Formatter::make_help(app, std::move(name), mode);
    for (std::size_t at = 0; (at = text.find("\n\n\n", at)) != std::string::npos;) text.erase(at, 1);
    return text;
  }
  /// CLI11 puts an empty line before the footer up to 2.3 alone; `make_help` leaves one of two.
  std::string make_footer(const CLI::App* app) const override {
    const std::string footer = app->get_footer();
    const std::size_t end = footer.find('\n');
    return "\n" + wrapped(footer.substr(0, end), 0, width_) + (end == std::string::npos ? "" : footer.substr(end)) + "\n";
  }
  std::string make_option(const CLI::Option* option, bool is_positional) const override {
    return entry(make_option_name(option, is_positional) + (is_positional ? "" : make_option_opts(option)),
                 option->get_description());
  }
  std::string make_subcommand(const CLI::App* app) const override { return entry(app->get_name(), app->get_description()); }

 private:
  [[nodiscard]] std::string entry(const std::string& name, const std::string& text) const {
    constexpr std::size_t indent = 22;
    const std::string head = "  " + name;
    return head + (head.size() + 2 > indent ? "\n" + std::string(indent, ' ') : std::string(indent - head.size(), ' ')) +
           wrapped(text, indent, width_) + "\n";
  }

  std::size_t width_ = std::clamp<std::size_t>(observe::terminal_columns(STDOUT_FILENO), 50, 110);
};

/// The end of --help: exit codes, then examples.
[[nodiscard]] inline std::string footer_of(const Command& command) {
  std::string text =
      "Exit codes: 0 done; 1 a run or a computation failed; 2 wrong arguments, nothing was started; 3 stopped by a signal";
  for (const std::string& example : command.examples) {
    text += (&example == command.examples.data() ? "\n\nExamples:\n  " : "\n  ") + example;
  }
  return text;
}

}  // namespace trophic::command::detail
