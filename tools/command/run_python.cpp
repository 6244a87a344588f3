// SPDX-License-Identifier: MIT
// Definitions of run_python.hpp.
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <system_error>
#include <tools/command/output.hpp>
#include <tools/command/provenance.hpp>
#include <tools/command/run_python.hpp>
#include <tools/command/this_program.hpp>

namespace trophic::command {

namespace {

/// The folder of the Python module: PREFIX/share/trophic/python next to PREFIX/bin, or of the trophic with which a program of another
/// project was built.
[[nodiscard]] std::filesystem::path module_folder(const std::filesystem::path& program) {
  std::filesystem::path folder = program.parent_path().parent_path() / "share/trophic/python";
  std::error_code ignored;
  const std::string otherwise = trophic_python_folder == nullptr ? "" : trophic_python_folder;
  if (!std::filesystem::is_directory(folder, ignored) && !otherwise.empty()) folder = otherwise;
  if (const auto file = folder / "trophic/command.py"; !std::filesystem::exists(file, ignored)) {
    throw std::invalid_argument{"the Python module is not installed: there is no " + file.string()};
  }
  return folder;
}

/// Makes a text what a program reads that this one becomes. Throws std::runtime_error if that fails.
void pass_to_standard_input(const std::string& text) {
  std::FILE* file = std::tmpfile();
  if (file == nullptr || std::fwrite(text.data(), 1, text.size(), file) != text.size() || std::fflush(file) != 0 ||
      ::lseek(::fileno(file), 0, SEEK_SET) != 0 || ::dup2(::fileno(file), STDIN_FILENO) < 0) {
    throw std::runtime_error{std::string{"cannot pass the request to Python by a temporary file: "} + std::strerror(errno)};
  }
}

[[nodiscard]] Json request_of(std::span<const Option> options) {
  Json request = Json::object();
  for (const Option& option : options) {
    std::string name = option.name.substr(std::min(option.name.find_first_not_of('-'), option.name.size()));
    std::ranges::replace(name, '-', '_');
    std::visit(
        [&](const auto* value) {
          if constexpr (requires { value->has_value(); }) {
            request[name] = *value ? Json(**value) : Json();
          } else {
            request[name] = *value;
          }
        },
        option.target);
  }
  return request;
}

}  // namespace

int run_python(Json request) {
  const std::filesystem::path program = program_path();
  const char* path = std::getenv("PYTHONPATH");
  const std::string others = path == nullptr || *path == '\0' ? "" : ":" + std::string{path};
  ::setenv("PYTHONPATH", (module_folder(program).string() + others).c_str(), 1);
  const char* named = std::getenv("TROPHIC_PYTHON");
  std::string python = named == nullptr ? "python3" : named;
  request["program"] = program.string();
  pass_to_standard_input(json_text(request));
  std::array<std::string, 2> words{"-m", "trophic.command"};
  const std::array<char*, 4> arguments{python.data(), words[0].data(), words[1].data(), nullptr};
  flush_output();
  ::execvp(python.c_str(), arguments.data());
  throw std::invalid_argument{python + ": " + std::strerror(errno) + "; TROPHIC_PYTHON names another Python"};
}

Command python_command(const std::string& program, Command command, std::function<void(Json&)> prepare) {
  command.work = [options = command.options, name = command.name, program, prepare = std::move(prepare)] {
    Json request = request_of(options);
    request["command"] = name;
    request["who"] = program + " " + name;
    prepare(request);
    return run_python(std::move(request));
  };
  return command;
}

}  // namespace trophic::command
