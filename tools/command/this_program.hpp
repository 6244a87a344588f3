// SPDX-License-Identifier: MIT
// Name and path of the running program.
#pragma once

#if defined(__APPLE__)
#include <mach-o/dyld.h>

#include <cstdint>
#include <cstdlib>
#else
#include <cerrno>
#endif

#include <filesystem>
#include <string>
#include <system_error>

namespace trophic {

/// The name in the command that started the program. Does not allocate memory.
[[nodiscard]] inline const char* invocation_name() {
#if defined(__APPLE__)
  return ::getprogname();
#else
  return program_invocation_name;
#endif
}

/// Sets `error` and returns an empty path if the system does not report it.
[[nodiscard]] inline std::filesystem::path program_path(std::error_code& error) {
#if defined(__APPLE__)
  std::string path(4096, '\0');
  auto size = static_cast<std::uint32_t>(path.size());
  if (::_NSGetExecutablePath(path.data(), &size) != 0) path.assign(1, '\0');
  return std::filesystem::canonical(path.c_str(), error);
#else
  return std::filesystem::read_symlink("/proc/self/exe", error);
#endif
}

/// Throws std::system_error if the system does not report it.
[[nodiscard]] inline std::filesystem::path program_path() {
  std::error_code error;
  std::filesystem::path path = program_path(error);
  if (error) throw std::system_error{error, "path of this program"};
  return path;
}

}  // namespace trophic
