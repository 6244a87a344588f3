// SPDX-License-Identifier: MIT
// The definitions of run_command.hpp: the only file that knows CLI11.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <functional>
#include <iostream>
#include <limits>
#include <new>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <trophic/command/completion.hpp>
#include <trophic/command/output.hpp>
#include <trophic/command/run_command.hpp>
#include <trophic/command/words.hpp>
#include <trophic/support/plain_text.hpp>
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

/// "NAME: WHAT" in one line on standard error: control characters, which a file's name may have, are written as \x0a. Takes no
/// memory.
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

/// Throws std::invalid_argument "--seed -1: must be >= 0" for what CLI11 would take for another number: -1 is 2^64 - 1 to it, 010
/// is 8.
TROPHIC_INLINE void check_whole_number(const std::string& option, const std::string& text) {
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

/// Throws std::invalid_argument for what CLI11 would read as a number though nobody writes one so: 0x10, 1e, an empty text.
TROPHIC_INLINE void check_decimal_number(const std::string& option, const std::string& text) {
  double value = 0.0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool all = read.ptr == text.data() + text.size() && !text.empty();
  if (!all || (read.ec != std::errc{} && read.ec != std::errc::result_out_of_range)) {
    throw std::invalid_argument{option + " " + text + ": must be a number in decimal digits"};
  }
}

/// Throws std::invalid_argument for an empty text: `--config "$FILE"` where FILE was never set would run something else.
TROPHIC_INLINE void check_text(const std::string& option, const std::string& text) {
  if (text.empty()) throw std::invalid_argument{option + ": must not be empty"};
}

/// A check that throws, as CLI11 takes it: what it returns would be a complaint.
TROPHIC_INLINE std::function<std::string(const std::string&)> validator(void (*check)(const std::string&, const std::string&),
                                                                        std::string option) {
  return [check, option = std::move(option)](const std::string& text) {
    check(option, text);
    return std::string{};
  };
}

/// Throws std::invalid_argument for a word that is none of those that an option takes.
TROPHIC_INLINE void check_word(const Option& option, const std::string& word) {
  if (std::ranges::find(option.words, word) != option.words.end()) return;
  throw std::invalid_argument{must_be_one_of(option.name + " " + word, option.words) +
                              did_you_mean(nearest_word(word, option.words))};
}

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
    if (added->get_type_name() == "UINT") {
      added->check(validator(check_whole_number, option.name));
    }
    if (added->get_type_name() == "FLOAT") {
      added->check(validator(check_decimal_number, option.name));
    }
    if (added->get_type_name() == "TEXT") {
      added->check(validator(check_text, option.name));
    }
    if (option.use == Words::demanded) {
      added->check([&option](const std::string& text) {
        check_word(option, text);
        return std::string{};
      });
    }
  }
}

/// The sentence about arguments that no option takes.
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

/// The shell that --completion names, looked for before anything else is checked; empty without the option.
[[nodiscard]] TROPHIC_INLINE std::string completion_shell(int argc, const char* const* argv) {
  constexpr std::string_view flag = "--completion";
  for (int i = 1; i < argc; ++i) {
    const std::string_view word{argv[i]};
    if (word == flag) return i + 1 < argc ? argv[i + 1] : "";
    if (word.starts_with(flag) && word.substr(flag.size()).starts_with('=')) return std::string{word.substr(flag.size() + 1)};
  }
  return "";
}

/// Lets an installed program find the models that were installed with it: PREFIX/share/trophic/models beside PREFIX/bin, where
/// TROPHIC_MODELS names no others.
TROPHIC_INLINE void use_installed_models() {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  const std::filesystem::path models = program.parent_path().parent_path() / "share/trophic/models";
  if (!error && std::filesystem::is_directory(models, error)) ::setenv("TROPHIC_MODELS", models.c_str(), 0);
}

/// Keeps the numbers of standard streams that were closed (`>&-`) from files that the program opens: what it prints would go
/// into a table. Nothing can be written to what stands there instead, so that it is noticed.
TROPHIC_INLINE void occupy_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) >= 0) continue;
    // It takes the lowest number that is free: this stream's.
    static_cast<void>(::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY));
  }
}

inline std::terminate_handler die_otherwise = nullptr;  ///< what std::terminate did before

/// Where memory ran out in a place that cannot throw, as in a destructor of a library that needs some: one line and `run_error`,
/// with everything as a killed program leaves it.
[[noreturn]] TROPHIC_INLINE void exit_with_message() noexcept {
  try {
    if (const std::exception_ptr thrown = std::current_exception()) std::rethrow_exception(thrown);
  } catch (const std::bad_alloc& error) {
    static_cast<void>(report_failure(program_invocation_name, error));
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
  std::string shell;
  std::vector<CLI::App*> added;
  const Command* chosen = &command;
  try {
    if (const std::string wanted = detail::completion_shell(argc, argv); !wanted.empty()) {
      if (wanted != "bash") throw std::invalid_argument{"--completion " + wanted + ": must be bash"};
      return print_text(bash_completion(command, name));
    }
    detail::add_options(app, command);
    if (!command.version.empty())
      app.set_version_flag("--version", command.version, "print what this program is made of and stop");
    app.add_option("--completion", shell, "print the completion for a shell and stop: source <(" + name + " --completion bash)")
        ->check(detail::validator(detail::check_text, "--completion"));
    for (const Command& subcommand : command.subcommands) {
      added.push_back(app.add_subcommand(subcommand.name, subcommand.about));
      detail::add_options(*added.back(), subcommand);
    }
    app.require_subcommand(0, 1);
    const auto choose = [&] {
      for (std::size_t i = 0; i < added.size(); ++i) {
        if (!added[i]->parsed()) continue;
        chosen = &command.subcommands[i];
        name += " " + chosen->name;
      }
    };
    try {
      app.parse(argc, argv);
      choose();
    } catch (const std::invalid_argument&) {
      choose();
      throw;
    } catch (const CLI::ExtrasError&) {
      choose();
      return report(detail::about_extras(app.remaining(true), *chosen), usage_error);
    } catch (const CLI::ParseError& error) {
      choose();
      if (error.get_exit_code() == 0) return app.exit(error);
      return report(error.what(), usage_error);
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
