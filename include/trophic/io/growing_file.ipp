// SPDX-License-Identifier: MIT
// Definitions of growing_file.hpp.
#pragma once

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <trophic/io/growing_file.hpp>
#include <trophic/support/checksum.hpp>

namespace trophic {

TROPHIC_INLINE GrowingFile::GrowingFile(const std::filesystem::path& path, Opening opening) : path_{path} {
  const bool is_new = opening == Opening::created;
  // O_NONBLOCK: the program must not wait for a reader of a pipe. O_RDWR: the content is compared with the checkpoint.
  const int flags = O_APPEND | O_CLOEXEC | O_NONBLOCK | O_NOFOLLOW | (is_new ? O_WRONLY | O_CREAT | O_EXCL : O_RDWR);
  file_ = ::open(path.c_str(), flags, 0666);
  if (file_ < 0 && errno == ELOOP) throw std::runtime_error{"cannot open " + path.string() + ": it is a symbolic link"};
  if (file_ < 0) fail(is_new ? "create" : "open");
  if (is_new) return;
  struct stat status {};
  const bool is_file = ::fstat(file_, &status) == 0 && S_ISREG(status.st_mode);
  if (!is_file || status.st_nlink > 1) {
    ::close(std::exchange(file_, -1));
    throw std::runtime_error{
        "cannot continue " + path.string() + ": " +
        (is_file ? "it has a second name (a hard link), whose file would change as well" : "it is not a regular file")};
  }
  length_ = static_cast<std::uint64_t>(status.st_size);
}

TROPHIC_INLINE GrowingFile::~GrowingFile() {
  if (file_ >= 0) ::close(file_);
}

TROPHIC_INLINE void GrowingFile::append(std::string_view bytes) {
  while (!bytes.empty()) {
    const ::ssize_t written = ::write(file_, bytes.data(), bytes.size());
    if (written < 0) {
      if (errno == EINTR) continue;
      fail("write");
    }
    checksum_ = trophic::checksum(bytes.substr(0, static_cast<std::size_t>(written)), checksum_);
    bytes.remove_prefix(static_cast<std::size_t>(written));
    length_ += static_cast<std::uint64_t>(written);
  }
}

TROPHIC_INLINE void GrowingFile::sync() {
  if (::fsync(file_) != 0) fail("write");
}

TROPHIC_INLINE void GrowingFile::persist(Archive& archive) {
  if (!archive.reads()) sync();
  std::uint64_t length = length_;
  std::uint32_t sum = checksum_;
  archive(length, sum);
  if (!archive.reads()) return;
  check_content(length, sum);
  if (::ftruncate(file_, static_cast<::off_t>(length)) != 0) fail("cut");
  length_ = length;
  checksum_ = sum;
}

TROPHIC_INLINE void GrowingFile::check_content(std::uint64_t length, std::uint32_t checksum) const {
  if (length > length_) {
    throw DamagedFile{"cannot continue " + path_.string() + ": it has " + std::to_string(length_) +
                      " bytes: must be >= " + std::to_string(length) + ", as many as it had at the checkpoint"};
  }
  std::array<char, 1U << 16U> piece;
  std::uint32_t sum = 0;
  for (std::uint64_t at = 0; at < length;) {
    const ::ssize_t got =
        ::pread(file_, piece.data(), std::min<std::uint64_t>(piece.size(), length - at), static_cast<::off_t>(at));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail("read");
    if (got == 0) break;
    sum = trophic::checksum({piece.data(), static_cast<std::size_t>(got)}, sum);
    at += static_cast<std::uint64_t>(got);
  }
  if (sum == checksum) return;
  throw DamagedFile{"cannot continue " + path_.string() + ": its first " + std::to_string(length) + " bytes have checksum " +
                    std::to_string(sum) + ": must be " + std::to_string(checksum) +
                    ", as at the checkpoint; the file was damaged or modified after the run wrote it"};
}

TROPHIC_INLINE void GrowingFile::fail(std::string_view what) const {
  throw std::runtime_error{"cannot " + std::string{what} + " " + path_.string() + ": " + std::strerror(errno)};
}

}  // namespace trophic
