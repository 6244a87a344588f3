// SPDX-License-Identifier: MIT
// A file that grows at its end and can be cut back to a length that it had.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>
#include <trophic/params/archive.hpp>
#include <trophic/support/linkage.hpp>

namespace trophic {

/// Whether the files of a run are made new or are those of a run that goes on.
enum class Opening { created, resumed };

/// Appends to a file. Throws std::runtime_error naming the file when the system refuses.
///
/// With `Opening::created` nothing of that name may exist. With `Opening::resumed` the file must exist; `persist` then cuts
/// it to the length that an archive says. Anything that observes a run and owns such files takes part in checkpoints by a
/// `persist` of its own that calls theirs.
class GrowingFile {
 public:
  GrowingFile(const std::filesystem::path& path, Opening opening);
  GrowingFile(GrowingFile&& other) noexcept;
  GrowingFile& operator=(GrowingFile&& other) noexcept;
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;
  ~GrowingFile();

  /// Hands the bytes to the system: a program that dies later has written them.
  void append(std::string_view bytes);

  /// Puts all bytes on the disk, so that not even a power failure takes them.
  void sync();

  /// How long the file is, bytes.
  [[nodiscard]] std::uint64_t length() const { return length_; }

  /// CRC-32 of all its bytes; of a file that a run goes on with, once `persist` has cut it.
  [[nodiscard]] std::uint32_t checksum() const { return checksum_; }

  /// Writing: puts all bytes on the disk and notes the length. Reading: cuts the file to the length that was noted, which nobody
  /// checks the content of. Throws std::runtime_error if it is shorter than that.
  void persist(Archive& archive);

 private:
  [[noreturn]] void fail(std::string_view what) const;
  void cut(std::uint64_t length);

  std::filesystem::path path_;
  int file_ = -1;
  std::uint64_t length_ = 0;
  std::uint32_t checksum_ = 0;
};

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/io/growing_file.ipp>
#endif
