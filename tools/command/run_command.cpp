// SPDX-License-Identifier: MIT
// Definitions of run_command.hpp.
#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <string_view>
#include <tools/command/command_parser.hpp>
#include <tools/command/prepare_process.hpp>
#include <tools/command/run_command.hpp>
#include <trophic/support/plain_text.hpp>
#include <utility>

namespace trophic::command {

std::string program_name(const char* called) {
  return std::filesystem::path{called}.filename().string();
}

std::string command_line(int argc, const char* const* argv) {
  std::string line;
  for (int i = 0; i < argc; ++i) line += (i == 0 ? "" : " ") + std::string{argv[i]};
  return line;
}

const char* what_of(const std::exception& error) {
  return dynamic_cast<const std::bad_alloc*>(&error) != nullptr ? "there is not enough memory" : error.what();
}

namespace detail {

/// Prints "NAME: WHAT" in one line on standard error; control characters, which a file's name may have, are written as \x0a.
/// Allocates no memory.
void print_error(std::string_view name, std::string_view what) {
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

int report_failure(const char* called, const std::exception& error) {
  const char* slash = std::strrchr(called, '/');
  detail::print_error(slash == nullptr ? called : slash + 1, what_of(error));
  return run_error;
}

int run_command(int argc, const char* const* argv, const Command& command) {
  detail::prepare_process();
  std::string name = program_name(argv[0]);
  const Command* chosen = &command;
  CLI::App app{command.about, name};
  const auto refuse = [&](const std::exception& error) {
    detail::print_error(name, error.what());
    return usage_error;
  };
  try {
    detail::add_program(app, command, [&](const Command& subcommand) {
      chosen = &subcommand;
      name += " " + subcommand.name;
    });
    app.parse(argc, argv);
    detail::check_arguments(app, command, *chosen);
    return chosen->work();
  } catch (const CLI::ArgumentMismatch& error) {
    return refuse(std::invalid_argument{detail::about_mismatch(*chosen, error.what())});
  } catch (const CLI::ParseError& error) {
    return error.get_exit_code() == 0 ? app.exit(error) : refuse(error);
  } catch (const std::invalid_argument& error) {
    return refuse(error);
  } catch (const std::exception& error) {
    return report_failure(name.c_str(), error);
  }
}

}  // namespace trophic::command
