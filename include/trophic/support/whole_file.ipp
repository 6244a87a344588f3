// SPDX-License-Identifier: MIT
// Definitions of whole_file.hpp.
#pragma once

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <trophic/support/whole_file.hpp>

namespace trophic {

TROPHIC_INLINE std::string read_whole_file(const std::filesystem::path& path, std::uint64_t most_bytes) {
  const auto refuse = [&](const std::string& why) { throw std::invalid_argument{path.string() + ": " + why}; };
  struct Opened {
    int file;
    ~Opened() {
      if (file >= 0) ::close(file);
    }
  };
  // O_NONBLOCK: opening a pipe without a writer would block.
  const Opened opened{::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)};
  if (opened.file < 0) refuse("cannot be read: " + std::string{std::strerror(errno)});
  struct stat status {};
  if (::fstat(opened.file, &status) != 0) refuse("cannot be read: " + std::string{std::strerror(errno)});
  if (!S_ISREG(status.st_mode)) refuse("is not a regular file");
  const auto size = static_cast<std::uint64_t>(status.st_size);
  if (size > most_bytes) refuse("has " + std::to_string(size) + " bytes: must be <= " + std::to_string(most_bytes));
  std::string text(size, '\0');
  std::size_t have = 0;
  while (have < text.size()) {
    const ::ssize_t got = ::read(opened.file, text.data() + have, text.size() - have);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) refuse("cannot be read: " + std::string{std::strerror(errno)});
    if (got == 0) break;
    have += static_cast<std::size_t>(got);
  }
  text.resize(have);
  return text;
}

}  // namespace trophic
