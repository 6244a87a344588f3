// SPDX-License-Identifier: MIT
// One program at a time in a folder.
#pragma once

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>

namespace trophic {

/// While it lives, no other FolderLock on the folder can be made, in this program or another; the system drops it when a program
/// dies. A file system without locks, as some of networks, gives none: then nobody is kept out.
class FolderLock {
 public:
  /// Throws std::runtime_error if the folder cannot be opened or is locked.
  explicit FolderLock(const std::filesystem::path& folder) : file_{::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)} {
    if (file_ < 0) throw std::runtime_error{folder.string() + ": is not a folder that can be opened"};
    if (::flock(file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
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
