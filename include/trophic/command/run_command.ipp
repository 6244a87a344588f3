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
#include <iostream>
#include <limits>
#include <memory>
#include <new>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <trophic/command/completion.hpp>
#include <trophic/command/output.hpp>
#include <trophic/command/run_command.hpp>
#include <trophic/command/words.hpp>
#include <trophic/observe/terminal.hpp>
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
TROPHIC_INLINE void complain(std::string_view name, std::string_view what) {
  std::array<char, 1024> line{};
  std::size_t used = 0;
  const auto write_out = [&] { std::fwrite(line.data(), 1, std::exchange(used, 0), stderr); };
  for (const std::string_view part : {name, std::string_view{": "}, what}) {
    for (const char character : part) {
      if (used + 8 > line.size()) write_out();
      const auto byte = static_cast<unsigned char>(character);
      const bool is_control = byte < 0x20 || byte == 0x7f;
      used += static_cast<std::size_t>(std::snprintf(line.data() + used, 5, is_control ? "\\x%02x" : "%c", unsigned{byte}));
    }
  }
  line[used++] = '\n';
  write_out();
}

}  // namespace detail

TROPHIC_INLINE int report_failure(const char* called, const std::exception& error) {
  const char* slash = std::strrchr(called, '/');
  detail::complain(slash == nullptr ? called : slash + 1, what_of(error));
  return run_error;
}

namespace detail {

/// Throws std::invalid_argument "--seed -1: must be >= 0" for texts that CLI11 reads as another number: -1 as 2^64 - 1, 010 as
/// 8.
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

/// Throws std::invalid_argument for texts that are not plain decimal numbers, some of which CLI11 accepts: 0x10, 1e, an empty
/// text.
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

/// Throws std::invalid_argument for a word that the option does not take.
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

/// A text in lines of at most `width` columns; each line after the first begins with `indent` blanks.
[[nodiscard]] TROPHIC_INLINE std::string wrapped(std::string_view text, std::size_t indent, std::size_t width) {
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
  std::string make_group(std::string group, bool is_positional, std::vector<const CLI::Option*> options) const override {
    std::string text = CLI::Formatter::make_group(std::move(group), is_positional, std::move(options));
    if (text.ends_with("\n\n")) text.pop_back();
    return text;
  }
  std::string make_footer(const CLI::App* app) const override {
    const std::string footer = app->get_footer();
    const std::size_t end = footer.find('\n');
    return wrapped(footer.substr(0, end), 0, width_) + (end == std::string::npos ? "" : footer.substr(end)) + "\n";
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
[[nodiscard]] TROPHIC_INLINE std::string footer_of(const Command& command) {
  std::string text =
      "Exit codes: 0 done; 1 a run or a computation failed; 2 wrong arguments, nothing was started; 3 stopped by a signal";
  for (const std::string& example : command.examples) {
    text += (&example == command.examples.data() ? "\n\nExamples:\n  " : "\n  ") + example;
  }
  return text;
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
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
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
[[noreturn]] TROPHIC_INLINE void give_up() noexcept {
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
  if (detail::die_otherwise == nullptr) detail::die_otherwise = std::set_terminate(&detail::give_up);
  detail::use_installed_models();
  std::string name = program_name(argv[0]);
  const auto report = [&](const std::string& what, int code) {
    detail::complain(name, what);
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
