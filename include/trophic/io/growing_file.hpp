// SPDX-License-Identifier: MIT
// A file that grows at its end and can be truncated to an earlier length.
#pragma once

#include <filesystem>
#include <trophic/params/archive.hpp>

namespace trophic {

/// Whether the files of a run are new or those of a run that is resumed.
enum class Opening { created, resumed };

/// A file of a run that differs from what the run wrote. The message names the file and what differs.
class DamagedFile : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Appends to a file. Throws std::runtime_error naming the file if the system refuses.
///
/// With `Opening::created`, no file may have this name. With `Opening::resumed`, the file must be a regular file without a second
/// name and must not be a link, so that nothing is written elsewhere. `persist` then compares it with the archive and truncates
/// it. An observer that owns such files takes part in checkpoints by its own `persist`, which calls theirs.
class GrowingFile {
 public:
  GrowingFile(const std::filesystem::path& path, Opening opening);
  GrowingFile(GrowingFile&& other) noexcept { *this = std::move(other); }
  GrowingFile& operator=(GrowingFile&& other) noexcept {
    std::swap(path_, other.path_);
    std::swap(file_, other.file_);
    std::swap(length_, other.length_);
    std::swap(checksum_, other.checksum_);
    return *this;
  }
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;
  ~GrowingFile();

  /// Passes the bytes to the operating system: they are written even if the program dies later.
  void append(std::string_view bytes);

  /// Writes all bytes to the disk, so that they survive a power failure.
  void sync();

  /// Returns the length of the file in bytes.
  [[nodiscard]] std::uint64_t length() const { return length_; }

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Returns the CRC-32 of all its bytes; in a resumed run only after `persist`.
  [[nodiscard]] std::uint32_t checksum() const { return checksum_; }

  /// Writing: writes all bytes to the disk and records length and checksum. Reading: truncates the file to that length. Throws
  /// DamagedFile, and leaves the file unchanged, if it is shorter or if its bytes up to that length have a different checksum.
  void persist(Archive& archive);

 private:
  [[noreturn]] void fail(std::string_view what) const;
  void check_content(std::uint64_t length, std::uint32_t checksum) const;

  std::filesystem::path path_;
  int file_ = -1;
  std::uint64_t length_ = 0;
  std::uint32_t checksum_ = 0;
};

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/io/growing_file.ipp>
#endif
