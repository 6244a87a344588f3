// SPDX-License-Identifier: MIT
// Definitions of whole_file.hpp.
#pragma once

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <trophic/support/unreadable_file.hpp>
#include <trophic/support/whole_file.hpp>

namespace trophic {

namespace detail {

/// A regular file that is read.
class ReadFile {
 public:
  explicit ReadFile(const std::filesystem::path& path, std::uint64_t from = 0) : path_{path} {
    // O_NONBLOCK: opening a pipe without a writer would wait.
    file_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    struct stat status {};
    if (file_ < 0 || ::fstat(file_, &status) != 0) {
      const int reason = errno;
      close();
      refuse_to_read(reason);
    }
    if (!S_ISREG(status.st_mode)) {
      close();
      refuse("is not a regular file");
    }
    size_ = static_cast<std::uint64_t>(status.st_size);
    ::lseek(file_, static_cast<::off_t>(std::min(from, size_)), SEEK_SET);
  }
  ReadFile(const ReadFile&) = delete;
  ReadFile& operator=(const ReadFile&) = delete;
  ~ReadFile() { close(); }

  [[nodiscard]] std::uint64_t size() const { return size_; }

  /// Its first bytes; fewer if it ends sooner.
  [[nodiscard]] std::string read(std::uint64_t bytes) const {
    std::string text(bytes, '\0');
    std::size_t have = 0;
    while (have < text.size()) {
      const ::ssize_t got = ::read(file_, text.data() + have, text.size() - have);
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) refuse_to_read(errno);
      if (got == 0) break;
      have += static_cast<std::size_t>(got);
    }
    text.resize(have);
    return text;
  }

  [[noreturn]] void refuse(const std::string& why) const { throw std::invalid_argument{path_.string() + ": " + why}; }

 private:
  [[noreturn]] void refuse_to_read(int reason) const {
    const std::string why = std::string{"cannot be read: "} + std::strerror(reason);
    for (const int is_no_file : {ENOENT, ENOTDIR, ELOOP, ENXIO, ENAMETOOLONG}) {
      if (reason == is_no_file) refuse(why);
    }
    throw UnreadableFile{path_.string() + ": " + why};
  }

  void close() {
    if (file_ >= 0) ::close(file_);
    file_ = -1;
  }

  std::filesystem::path path_;
  int file_ = -1;
  std::uint64_t size_ = 0;
};

}  // namespace detail

// Both throw UnreadableFile, an std::invalid_argument, if the system cannot read an existing file.
TROPHIC_INLINE std::string read_whole_file(const std::filesystem::path& path, std::uint64_t most_bytes) {
  const detail::ReadFile file{path};
  if (file.size() > most_bytes) {
    file.refuse("has " + std::to_string(file.size()) + " bytes: must be <= " + std::to_string(most_bytes));
  }
  return file.read(file.size());
}

TROPHIC_INLINE std::string read_part(const std::filesystem::path& path, std::size_t bytes, std::uint64_t from) {
  return detail::ReadFile{path, from}.read(bytes);
}

}  // namespace trophic
