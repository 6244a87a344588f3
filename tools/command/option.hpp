// SPDX-License-Identifier: MIT
// A command and its options as data: what is parsed, explained by --help and checked.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace trophic::command {

/// Destination of an option's value. A bool makes a flag; a vector makes an option that may be repeated.
using Target = std::variant<bool*, std::string*, std::optional<std::string>*, std::uint64_t*, std::optional<std::uint64_t>*,
                            double*, std::optional<double>*, std::vector<std::string>*, std::vector<std::uint64_t>*>;

/// One option, or one positional argument.
struct Option {
  std::string name;  ///< "--seed"; the name of a positional argument has no dashes
  Target target;
  std::string help;
  std::vector<std::string> words = {};  ///< the only values accepted; if empty, the command checks the value
  std::size_t values = 0;               ///< how many values a vector takes at once; 0: any number
  bool required = false;
  std::string shorthand = {};  ///< "-o"
  std::string group = {};      ///< heading in --help; empty: "Options"
  // Names of options: combinations without effect are refused before any work.
  std::vector<std::string> needs = {};      ///< one of these must be given too
  std::vector<std::string> not_with = {};   ///< none of these may be given
  std::vector<std::string> only_with = {};  ///< no option but these may be given; empty: any may
};

/// The same options under one heading of --help.
[[nodiscard]] inline std::vector<Option> in_group(const std::string& group, std::vector<Option> options) {
  for (Option& option : options) option.group = group;
  return options;
}

/// A program or one of its subcommands.
struct Command {
  std::string name;   ///< of a subcommand; a program has the name by which it was called
  std::string about;  ///< first lines of --help
  std::vector<Option> options = {};
  std::function<int()> work = {};  ///< returns the exit code; empty if a subcommand must be named
  std::vector<Command> subcommands = {};
  std::string version = {};                 ///< what --version prints
  std::vector<std::string> examples = {};   ///< command lines, the last lines of --help
  std::vector<std::string> elsewhere = {};  ///< names of further commands, each a separate program
};

/// Exit codes: errors in the arguments, and errors at run time.
inline constexpr int usage_error = 2;
inline constexpr int run_error = 1;
/// A signal interrupted the work; the same command with --resume resumes it.
inline constexpr int stopped = 3;

}  // namespace trophic::command
