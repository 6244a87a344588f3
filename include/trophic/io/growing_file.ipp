// SPDX-License-Identifier: MIT
// Definitions of growing_file.hpp.
#pragma once

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <trophic/io/growing_file.hpp>
#include <trophic/support/checksum.hpp>
#include <utility>

namespace trophic {

TROPHIC_INLINE GrowingFile::GrowingFile(const std::filesystem::path& path, Opening opening) : path_{path} {
  const bool is_new = opening == Opening::created;
  // O_NONBLOCK: a pipe in a file's place must not make the program wait for a reader.
  const int flags = O_WRONLY | O_APPEND | O_CLOEXEC | O_NONBLOCK | (is_new ? O_CREAT | O_EXCL : 0);
  file_ = ::open(path.c_str(), flags, 0666);
  if (file_ < 0) fail(is_new ? "create" : "open");
  if (is_new) return;
  struct stat status {};
  if (::fstat(file_, &status) != 0 || !S_ISREG(status.st_mode)) {
    ::close(std::exchange(file_, -1));
    throw std::runtime_error{"cannot go on with " + path.string() + ": it is not a regular file"};
  }
  length_ = static_cast<std::uint64_t>(status.st_size);
}

TROPHIC_INLINE GrowingFile::GrowingFile(GrowingFile&& other) noexcept
    : path_{std::move(other.path_)}, file_{std::exchange(other.file_, -1)}, length_{other.length_}, checksum_{other.checksum_} {}

TROPHIC_INLINE GrowingFile& GrowingFile::operator=(GrowingFile&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(file_, other.file_);
  std::swap(length_, other.length_);
  std::swap(checksum_, other.checksum_);
  return *this;
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
  cut(length);
  checksum_ = sum;
}

TROPHIC_INLINE void GrowingFile::cut(std::uint64_t length) {
  if (length > length_) {
    throw std::runtime_error{"cannot go on with " + path_.string() + ": it has " + std::to_string(length_) +
                             " bytes: must be >= " + std::to_string(length) + ", as many as it had at the checkpoint"};
  }
  if (::ftruncate(file_, static_cast<::off_t>(length)) != 0) fail("cut");
  length_ = length;
}

TROPHIC_INLINE void GrowingFile::fail(std::string_view what) const {
  throw std::runtime_error{"cannot " + std::string{what} + " " + path_.string() + ": " + std::strerror(errno)};
}

}  // namespace trophic
