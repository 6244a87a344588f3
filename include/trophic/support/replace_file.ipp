// SPDX-License-Identifier: MIT
// Definitions of replace_file.hpp.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <trophic/support/replace_file.hpp>

namespace trophic {

TROPHIC_INLINE void replace_file(const std::filesystem::path& path, std::string_view text,
                                 const std::filesystem::path& predecessor) {
  const auto require = [&](bool good) {
    if (!good) throw std::runtime_error{"cannot write " + path.string() + ": " + std::strerror(errno)};
  };
  const std::string temporary = path.string() + ".part";
  {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file{std::fopen(temporary.c_str(), "wb"), &std::fclose};
    require(file != nullptr);
    require(std::fwrite(text.data(), 1, text.size(), file.get()) == text.size());
    require(std::fflush(file.get()) == 0 && ::fsync(::fileno(file.get())) == 0);
  }
  if (!predecessor.empty()) require(std::rename(path.c_str(), predecessor.c_str()) == 0 || errno == ENOENT);
  require(std::rename(temporary.c_str(), path.c_str()) == 0);
  // The new name is an entry of the folder. Some file systems cannot sync a folder: then the system does it in its own time.
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path{"."};
  if (const int entry = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); entry >= 0) {
    static_cast<void>(::fsync(entry));
    ::close(entry);
  }
}

}  // namespace trophic
