// SPDX-License-Identifier: MIT
// A command and its subcommands as a parser of CLI11, for run_command.cpp.
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <tools/command/check_value.hpp>
#include <tools/command/help_text.hpp>
#include <tools/command/output.hpp>
#include <tools/command/words.hpp>
#include <type_traits>
#include <variant>
#include <vector>

namespace trophic::command::detail {

[[nodiscard]] inline bool is_named(const Option& option) {
  return option.name.starts_with('-');
}

inline void add_option(CLI::App& app, const Option& option) {
  const std::string name = option.shorthand.empty() ? option.name : option.shorthand + "," + option.name;
  CLI::Option& added = *std::visit(
      [&](auto* target) -> CLI::Option* {
        if constexpr (std::is_same_v<decltype(target), bool*>) {
          return app.add_flag(name, *target, option.help);
        } else {
          return app.add_option(name, *target, option.help);
        }
      },
      option.target);
  added.required(option.required);
  if (option.values > 0) added.expected(static_cast<int>(option.values));
  if (!option.group.empty()) added.group(option.group);
  const std::string type = added.get_type_name();
  // The check throws; CLI11 would turn a returned text into an error message of its own.
  added.check([&option, type](const std::string& text) {
    if (type == "UINT") check_whole_number(option.name, text);
    if (type == "FLOAT") check_decimal_number(option.name, text);
    if (type == "TEXT") check_text(option.name, text);
    if (!option.words.empty()) check_word(option, text);
    return std::string{};
  });
  if (is_named(option))
    added.option_text(type == "UINT" ? "N" : type == "FLOAT" ? "X" : type.empty() || type == "BOOLEAN" ? "" : "TEXT");
}

/// Adds the command's options, help and subcommands.
inline void add_command(CLI::App& app, const Command& command) {
  for (const Option& option : command.options) add_option(app, option);
  app.set_help_flag("-h,--help", "print this help and exit")->group("Help");
  app.footer(footer_of(command));
  for (const Command& subcommand : command.subcommands) {
    add_command(*app.add_subcommand(subcommand.name, subcommand.about)->group("Commands"), subcommand);
  }
}

/// Adds a program's command and --version. Passes the named subcommand to `choose`.
inline void add_program(CLI::App& app, const Command& command, const std::function<void(const Command&)>& choose) {
  app.formatter(help_formatter());
  app.require_subcommand(0, 1);
  app.allow_extras();  // check_arguments reports them more clearly
  add_command(app, command);
  for (const Command& subcommand : command.subcommands) {
    app.get_subcommand(subcommand.name)->preparse_callback([&subcommand, choose](std::size_t) { choose(subcommand); });
  }
  const std::string program = app.get_name();
  if (!command.version.empty())
    app.set_version_flag("--version", command.version, "print the versions of this program and its engines and exit")
        ->group("Help");
}

/// The names of all commands.
[[nodiscard]] inline std::vector<std::string> command_names(const Command& command) {
  std::vector<std::string> names;
  for (const Command& subcommand : command.subcommands) names.push_back(subcommand.name);
  names.insert(names.end(), command.elsewhere.begin(), command.elsewhere.end());
  return names;
}

/// Returns the error message for arguments that no option takes.
[[nodiscard]] inline std::string about_extras(const std::vector<std::string>& extras, const Command& command) {
  const auto option = std::ranges::find_if(extras, [](const std::string& extra) { return extra.starts_with('-'); });
  std::vector<std::string> names;
  if (option != extras.end()) {
    const std::string word = option->substr(0, option->find('='));
    names = {"--help", "--version"};
    for (const Option& each : command.options) {
      if (is_named(each)) names.push_back(each.name);
    }
    return word + ": unknown option" + did_you_mean(nearest_word(word, names)) + " (--help lists all)";
  }
  const std::string& word = extras.front();
  names = command_names(command);
  if (names.empty()) return word + ": unexpected argument (--help lists all)";
  return must_be_one_of(word, names) + did_you_mean(nearest_word(word, names));
}

/// CLI11's error about an option with too few or too many values, in plain words: "--runs: needs 2 values".
[[nodiscard]] inline std::string about_mismatch(const Command& command, const std::string& complaint) {
  const std::string name = complaint.substr(0, complaint.find(':'));
  const auto option = std::ranges::find(command.options, name, &Option::name);
  const std::size_t values = option == command.options.end() ? 0 : option->values;
  return values > 1 ? name + ": needs " + std::to_string(values) + " values" : name + ": needs a value";
}

/// Throws std::invalid_argument for options that have no effect together.
inline void check_combinations(const CLI::App& app, const Command& command) {
  const auto given = [&](const std::string& name) { return app.get_option_no_throw(name) != nullptr && app.count(name) > 0; };
  for (const Option& option : command.options) {
    if (!given(option.name)) continue;
    if (!option.needs.empty() && std::ranges::none_of(option.needs, given)) {
      throw std::invalid_argument{option.name + ": needs " + one_of(option.needs)};
    }
    if (const auto other = std::ranges::find_if(option.not_with, given); other != option.not_with.end()) {
      throw std::invalid_argument{option.name + ": not with " + *other};
    }
    if (option.only_with.empty()) continue;
    for (const Option& other : command.options) {
      if (&other == &option || !given(other.name) || std::ranges::find(option.only_with, other.name) != option.only_with.end())
        continue;
      throw std::invalid_argument{other.name + ": not with " + option.name + ", which combines with " + one_of(option.only_with) +
                                  " only"};
    }
  }
}

/// Throws std::invalid_argument for arguments that no option takes, for options of the program that the chosen subcommand lacks,
/// and if a subcommand must be named.
inline void check_arguments(const CLI::App& app, const Command& command, const Command& chosen) {
  if (const auto extras = app.remaining(true); !extras.empty()) throw std::invalid_argument{about_extras(extras, chosen)};
  for (const Option& option : command.options) {
    if (&chosen != &command && is_named(option) && app.count(option.name) > 0)
      throw std::invalid_argument{option.name + ": not with " + chosen.name};
  }
  check_combinations(&chosen == &command ? app : *app.get_subcommand(chosen.name), chosen);
  if (chosen.work) return;
  throw std::invalid_argument{"needs a command: " + one_of(command_names(command))};
}

}  // namespace trophic::command::detail
