// SPDX-License-Identifier: MIT
// Definitions of new_file.hpp.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <trophic/support/folder_lock.hpp>
#include <trophic/support/new_file.hpp>
#include <trophic/support/replace_file.ipp>
#include <utility>

namespace trophic {

namespace detail {

/// Opens a file and locks it. Returns -1, with errno, if the system refuses; errno is EWOULDBLOCK if another program holds the
/// lock.
[[nodiscard]] inline int open_locked(const std::filesystem::path& path, int more_flags) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | O_NONBLOCK | O_NOFOLLOW | more_flags, 0666);
  if (file < 0 || lock_named(file, path)) return file;
  ::close(file);
  errno = EWOULDBLOCK;
  return -1;
}

/// Gives a file an unused name. Returns false, with errno, if the name is taken or if the system refuses.
[[nodiscard]] inline bool rename_to_free(const std::filesystem::path& from, const std::filesystem::path& to) {
#ifdef RENAME_NOREPLACE
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return true;
  if (errno != EINVAL && errno != ENOSYS) return false;  // else the file system cannot do it
#endif
  if (std::filesystem::exists(std::filesystem::symlink_status(to))) {
    errno = EEXIST;
    return false;
  }
  return std::rename(from.c_str(), to.c_str()) == 0;
}

}  // namespace detail

TROPHIC_INLINE NewFile::NewFile(std::filesystem::path path) : path_{std::move(path)}, part_{path_.string() + ".part"} {
  const auto refuse = [&](const std::string& why) { throw std::runtime_error{"cannot create " + path_.string() + ": " + why}; };
  const auto reason = [] {
    return errno == EWOULDBLOCK || errno == EEXIST ? "another program is writing it" : std::strerror(errno);
  };
  if (std::filesystem::exists(std::filesystem::symlink_status(path_))) refuse("it exists");
  if (std::filesystem::is_symlink(std::filesystem::symlink_status(part_))) ::unlink(part_.c_str());
  const auto status = std::filesystem::symlink_status(part_);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    refuse(part_.string() + " already exists and is not a file");
  }
  const int left = detail::open_locked(part_, 0);
  if (left < 0) refuse(reason());
  // Not the file itself: a child of a killed program may still write to it.
  if (::unlink(part_.c_str()) == 0) file_ = detail::open_locked(part_, O_EXCL);
  const std::string why = file_ < 0 ? reason() : "";
  ::close(left);
  if (file_ < 0) refuse(why);
}

TROPHIC_INLINE NewFile::~NewFile() {
  if (file_ < 0) return;
  ::unlink(part_.c_str());
  ::close(file_);
}

TROPHIC_INLINE std::string NewFile::opened_again() const {
#if defined(__linux__)
  const std::string path = "/proc/" + std::to_string(::getpid()) + "/fd/" + std::to_string(file_);
  if (::access(path.c_str(), W_OK) == 0) return path;  // else /proc is not mounted
#endif
  return part_.string();
}

TROPHIC_INLINE void NewFile::write(std::string_view text) {
  if (!detail::write_all(file_, text)) throw std::runtime_error{"cannot write " + path_.string() + ": " + std::strerror(errno)};
}

TROPHIC_INLINE void NewFile::finish() {
  if (::fsync(file_) != 0 || !detail::rename_to_free(part_, path_)) {
    throw std::runtime_error{"cannot write " + path_.string() + ": " + std::strerror(errno)};
  }
  ::close(std::exchange(file_, -1));
}

TROPHIC_INLINE void write_new_file(const std::filesystem::path& path, std::string_view text) {
  NewFile file{path};
  file.write(text);
  file.finish();
}

}  // namespace trophic
