// SPDX-License-Identifier: MIT
// Definitions of found_programs.hpp.
#include "found_programs.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <tools/command/this_program.hpp>
#include <vector>

namespace trophic::command {

namespace {

constexpr std::string_view prefix = "trophic-";

/// Where programs may be: never the folder that the user works in.
[[nodiscard]] std::vector<std::filesystem::path> program_folders() {
  std::error_code error;
  std::vector<std::filesystem::path> folders{program_path(error).parent_path()};
  if (const char* path = std::getenv("PATH"); path != nullptr) {
    std::istringstream all{path};
    for (std::string folder; std::getline(all, folder, ':');) {
      if (folder.starts_with('/')) folders.emplace_back(folder);
    }
  }
  return folders;
}

[[nodiscard]] bool is_program(const std::filesystem::path& path) {
  std::error_code unknown;
  return std::filesystem::is_regular_file(path, unknown) && ::access(path.c_str(), X_OK) == 0;
}

}  // namespace

std::map<std::string, std::filesystem::path> found_programs() {
  std::map<std::string, std::filesystem::path> found;
  for (const std::filesystem::path& folder : program_folders()) {
    std::error_code error;
    for (std::filesystem::directory_iterator entry{folder, error}, end; !error && entry != end; entry.increment(error)) {
      const std::string name = entry->path().filename().string();
      if (name.starts_with(prefix) && is_program(entry->path())) found.emplace(name.substr(prefix.size()), entry->path());
    }
  }
  return found;
}

std::filesystem::path found_program(const std::string& name) {
  for (const std::filesystem::path& folder : program_folders()) {
    std::filesystem::path path = folder / (std::string{prefix} + name);
    if (is_program(path)) return path;
  }
  return {};
}

void become(const std::filesystem::path& program, char** argv) {
  const std::string path = program.string();
  argv[1] = const_cast<char*>(path.c_str());
  ::execv(path.c_str(), argv + 1);
  throw std::invalid_argument{path + ": " + std::strerror(errno)};
}

}  // namespace trophic::command
