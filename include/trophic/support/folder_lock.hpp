// SPDX-License-Identifier: MIT
// Gives one program at a time access to a folder.
#pragma once

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <trophic/support/cpp20.hpp>
#include <utility>

namespace trophic {

/// Locks an open file. Returns false if another program holds the lock, or has removed or replaced the file meanwhile.
[[nodiscard]] inline bool lock_named(int file, const std::filesystem::path& name) {
  if (::flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) return false;
  struct stat opened {};
  struct stat there {};
  return ::fstat(file, &opened) == 0 && ::stat(name.c_str(), &there) == 0 && opened.st_dev == there.st_dev &&
         opened.st_ino == there.st_ino;
}

/// During its lifetime no other FolderLock on the folder can be made, in this program or another. The system releases it when a
/// program dies. On network file systems without locks it has no effect.
class FolderLock {
 public:
  /// Throws std::runtime_error if the folder cannot be opened, is locked, or has just been removed by the program that held it.
  explicit FolderLock(const std::filesystem::path& folder) : file_{::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)} {
    if (file_ < 0) throw std::runtime_error{folder.string() + ": cannot be opened as a folder: " + std::strerror(errno)};
    if (!lock_named(file_, folder)) {
      ::close(file_);
      throw std::runtime_error{folder.string() + ": another program is running in it"};
    }
  }
  FolderLock(FolderLock&& other) noexcept : file_{std::exchange(other.file_, -1)} {}
  FolderLock& operator=(FolderLock&& other) noexcept {
    std::swap(file_, other.file_);
    return *this;
  }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock() {
    if (file_ >= 0) ::close(file_);
  }

 private:
  int file_;
};

}  // namespace trophic
