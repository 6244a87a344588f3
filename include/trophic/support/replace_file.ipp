// SPDX-License-Identifier: MIT
// Definitions of replace_file.hpp.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>
#include <trophic/support/replace_file.hpp>

namespace trophic {

namespace detail {

/// Makes an empty file. An existing file with that name is removed, not written to, because it may be a link or have a second
/// name. Returns -1, with errno, if the system refuses.
[[nodiscard]] inline int open_fresh(const std::string& path) {
  if (::unlink(path.c_str()) != 0 && errno != ENOENT) return -1;
  return ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
}

/// Writes all of a text. False, with errno, if the system refuses.
[[nodiscard]] inline bool write_all(int file, std::string_view text) {
  bool good = true;
  while (good && !text.empty()) {
    const ::ssize_t written = ::write(file, text.data(), text.size());
    if (written >= 0) {
      text.remove_prefix(static_cast<std::size_t>(written));
    } else {
      good = errno == EINTR;
    }
  }
  return good;
}

}  // namespace detail

TROPHIC_INLINE void replace_file(const std::filesystem::path& path, const std::function<void(const PutText& put)>& write,
                                 const std::filesystem::path& predecessor) {
  const auto require = [&](bool good) {
    if (!good) throw std::runtime_error{"cannot write " + path.string() + ": " + std::strerror(errno)};
  };
  const std::string temporary = path.string() + ".part";
  const int file = detail::open_fresh(temporary);
  require(file >= 0);
  const std::shared_ptr<void> closed{nullptr, [file](void*) { ::close(file); }};
  write([&](std::string_view text, std::uint64_t at) {
    require(::lseek(file, static_cast<::off_t>(at), SEEK_SET) >= 0 && detail::write_all(file, text));
  });
  require(::fsync(file) == 0);
  if (!predecessor.empty()) require(std::rename(path.c_str(), predecessor.c_str()) == 0 || errno == ENOENT);
  require(std::rename(temporary.c_str(), path.c_str()) == 0);
  // The new name is an entry of the folder. Some file systems cannot sync a folder; the system then writes it later.
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path{"."};
  if (const int entry = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); entry >= 0) {
    static_cast<void>(::fsync(entry));
    ::close(entry);
  }
}

TROPHIC_INLINE void sync_file(const std::filesystem::path& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
  const bool is_synced = file >= 0 && ::fsync(file) == 0;
  const int reason = errno;
  if (file >= 0) ::close(file);
  if (!is_synced) throw std::runtime_error{"cannot write " + path.string() + ": " + std::strerror(reason)};
}

}  // namespace trophic
