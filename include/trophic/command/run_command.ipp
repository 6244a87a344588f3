// SPDX-License-Identifier: MIT
// Definitions of run_command.hpp; this file and help_text.ipp use CLI11.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>
#include <new>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <trophic/command/check_value.hpp>
#include <trophic/command/completion.hpp>
#include <trophic/command/help_text.ipp>
#include <trophic/command/output.hpp>
#include <trophic/command/run_command.hpp>
#include <trophic/command/words.hpp>
#include <trophic/support/plain_text.hpp>
#include <trophic/support/this_program.hpp>
#include <type_traits>
#include <utility>

namespace trophic::command {

TROPHIC_INLINE std::string program_name(const char* called) {
  return std::filesystem::path{called}.filename().string();
}

TROPHIC_INLINE std::string command_line(int argc, const char* const* argv) {
  std::string line;
  for (int i = 0; i < argc; ++i) line += (i == 0 ? "" : " ") + std::string{argv[i]};
  return line;
}

TROPHIC_INLINE const char* what_of(const std::exception& error) {
  return dynamic_cast<const std::bad_alloc*>(&error) != nullptr ? "there is not enough memory" : error.what();
}

namespace detail {

/// Prints "NAME: WHAT" in one line on standard error; control characters, which a file's name may have, are written as \x0a.
/// Allocates no memory.
TROPHIC_INLINE void print_error(std::string_view name, std::string_view what) {
  std::array<char, 1024> line{};
  std::size_t used = 0;
  const auto write_out = [&] { std::fwrite(line.data(), 1, std::exchange(used, 0), stderr); };
  for (const std::string_view part : {name, std::string_view{": "}, what}) {
    std::size_t control = 0;
    for (std::size_t i = 0; i < part.size(); ++i) {
      if (used + 8 > line.size()) write_out();
      if (control == 0) control = control_bytes(part.substr(i));
      const auto byte = static_cast<unsigned char>(part[i]);
      used += static_cast<std::size_t>(std::snprintf(line.data() + used, 5, control > 0 ? "\\x%02x" : "%c", unsigned{byte}));
      if (control > 0) --control;
    }
  }
  line[used++] = '\n';
  write_out();
}

}  // namespace detail

TROPHIC_INLINE int report_failure(const char* called, const std::exception& error) {
  const char* slash = std::strrchr(called, '/');
  detail::print_error(slash == nullptr ? called : slash + 1, what_of(error));
  return run_error;
}

namespace detail {

TROPHIC_INLINE void add_options(CLI::App& app, const Command& command) {
  for (const Option& option : command.options) {
    const std::string name = option.shorthand.empty() ? option.name : option.shorthand + "," + option.name;
    CLI::Option* added = std::visit(
        [&](auto* target) -> CLI::Option* {
          using T = std::remove_pointer_t<decltype(target)>;
          if constexpr (std::is_same_v<T, bool>) {
            return app.add_flag(name, *target, option.help);
          } else {
            return app.add_option(name, *target, option.help);
          }
        },
        option.target);
    if (option.values > 0) added->expected(static_cast<int>(option.values));
    added->required(option.required);
    if (!option.group.empty()) added->group(option.group);
    const std::string type = added->get_type_name();
    // A check throws; a text that it returned would be a complaint of CLI11's own.
    added->check([&option, type](const std::string& text) {
      if (type == "UINT") check_whole_number(option.name, text);
      if (type == "FLOAT") check_decimal_number(option.name, text);
      if (type == "TEXT") check_text(option.name, text);
      if (option.use == Words::demanded) check_word(option, text);
      return std::string{};
    });
    if (is_named(option))
      added->option_text(type == "UINT" ? "N" : type == "FLOAT" ? "X" : type.empty() || type == "BOOLEAN" ? "" : "TEXT");
  }
}

/// The sentence about arguments that belong to no option.
[[nodiscard]] TROPHIC_INLINE std::string about_extras(const std::vector<std::string>& extras, const Command& command) {
  std::string word = extras.front();
  for (const std::string& extra : extras) {
    if (extra.starts_with('-')) {
      word = extra.substr(0, extra.find('='));
      break;
    }
  }
  std::vector<std::string> names;
  const bool is_option = word.starts_with('-');
  if (is_option) {
    names = {"--help", "--version", "--completion"};
    for (const Option& option : command.options) {
      if (is_named(option)) names.push_back(option.name);
    }
  } else {
    for (const Command& subcommand : command.subcommands) names.push_back(subcommand.name);
    if (!names.empty()) return must_be_one_of(word, names) + did_you_mean(nearest_word(word, names));
  }
  return word + (is_option ? ": unknown option" : ": unexpected argument") + did_you_mean(nearest_word(word, names)) +
         " (--help lists all)";
}

/// Lets an installed program find the models that were installed with it: PREFIX/share/trophic/models next to PREFIX/bin, unless
/// TROPHIC_MODELS names others.
TROPHIC_INLINE void use_installed_models() {
  std::error_code error;
  const std::filesystem::path program = program_path(error);
  const std::filesystem::path models = program.parent_path().parent_path() / "share/trophic/models";
  if (!error && std::filesystem::is_directory(models, error)) ::setenv("TROPHIC_MODELS", models.c_str(), 0);
}

/// Keeps the numbers of standard streams that were closed (`>&-`) from files that the program opens: otherwise its messages would
/// go into a table. Writing to the replacement fails, so that it is noticed.
TROPHIC_INLINE void occupy_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) >= 0) continue;
    // It takes the lowest number that is free: this stream's.
    static_cast<void>(::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY));
  }
}

inline std::terminate_handler die_otherwise = nullptr;  ///< what std::terminate did before

/// If memory runs out in a place that cannot throw, such as a destructor of a library: one line and `run_error`, and files as a
/// killed program leaves them.
[[noreturn]] TROPHIC_INLINE void exit_with_message() noexcept {
  try {
    if (const std::exception_ptr thrown = std::current_exception()) std::rethrow_exception(thrown);
  } catch (const std::bad_alloc& error) {
    static_cast<void>(report_failure(invocation_name(), error));
    std::_Exit(run_error);
  } catch (...) {  // a bug: dies as without this
  }
  die_otherwise();
  std::abort();
}

}  // namespace detail

TROPHIC_INLINE int run_command(int argc, const char* const* argv, const Command& command) {
  detail::occupy_closed_streams();
  if (detail::die_otherwise == nullptr) detail::die_otherwise = std::set_terminate(&detail::exit_with_message);
  detail::use_installed_models();
  std::string name = program_name(argv[0]);
  const auto report = [&](const std::string& what, int code) {
    detail::print_error(name, what);
    return code;
  };
  CLI::App app{command.about, name};
  app.formatter(std::make_shared<detail::HelpText>());
  app.footer(detail::footer_of(command));
  app.require_subcommand(0, 1);
  app.set_help_flag();
  const auto add_help = [](CLI::App& to) { to.set_help_flag("-h,--help", "print this help and stop")->group("Help"); };
  try {
    detail::add_options(app, command);
    add_help(app);
    if (!command.version.empty())
      app.set_version_flag("--version", command.version, "print what this program is made of and stop")->group("Help");
    app.add_option_function<std::string>(
           "--completion",
           [&, program = name](const std::string& shell) {
             detail::check_text("--completion", shell);
             if (shell != "bash" && shell != "zsh")
               throw std::invalid_argument{"--completion " + shell + ": must be bash or zsh"};
             static_cast<void>(
                 print_text(shell == "bash" ? bash_completion(command, program) : zsh_completion(command, program)));
             throw CLI::Success{};
           },
           "print the completion for bash or zsh and stop: source <(" + name + " --completion bash)")
        ->option_text("SHELL")
        ->group("Help")
        ->trigger_on_parse();
    for (const Command& subcommand : command.subcommands) {
      CLI::App& added = *app.add_subcommand(subcommand.name, subcommand.about)->group("Commands");
      added.footer(detail::footer_of(subcommand));
      added.set_help_flag();
      detail::add_options(added, subcommand);
      add_help(added);
    }
    std::exception_ptr refused;
    try {
      app.parse(argc, argv);
    } catch (...) {
      refused = std::current_exception();
    }
    const Command* chosen = &command;
    for (const CLI::App* named : app.get_subcommands()) {
      chosen = &*std::ranges::find(command.subcommands, named->get_name(), &Command::name);
      name += " " + chosen->name;
    }
    try {
      if (refused) std::rethrow_exception(refused);
    } catch (const CLI::ExtrasError&) {
      return report(detail::about_extras(app.remaining(true), *chosen), usage_error);
    } catch (const CLI::ParseError& error) {
      return error.get_exit_code() == 0 ? app.exit(error) : report(error.what(), usage_error);
    }
    if (chosen != &command) {
      for (const Option& option : command.options) {
        if (detail::is_named(option) && app.count(option.name) > 0)
          return report(option.name + ": not with " + chosen->name, usage_error);
      }
    }
    if (chosen->work) return chosen->work();
    std::vector<std::string> names;
    for (const Command& subcommand : command.subcommands) names.push_back(subcommand.name);
    return report("needs a command: " + one_of(names), usage_error);
  } catch (const std::invalid_argument& error) {
    return report(error.what(), usage_error);
  } catch (const std::exception& error) {
    return report_failure(name.c_str(), error);
  }
}

}  // namespace trophic::command
