// SPDX-License-Identifier: MIT
// A file that has its name only once it is whole: who is killed half-way leaves none that looks complete.
#pragma once

#include <filesystem>
#include <string_view>
#include <trophic/support/linkage.hpp>

namespace trophic {

/// A new file in the making, as "PATH.part"; what a killed program left there is made anew. Errors are std::runtime_error naming
/// the file.
class NewFile {
 public:
  /// Throws if something has the name already, if the system makes no file beside it, or if another program is making it.
  explicit NewFile(std::filesystem::path path);
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;
  /// What was not finished goes.
  ~NewFile();

  /// Its name.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Where to write until then: an empty file.
  [[nodiscard]] const std::filesystem::path& part() const { return part_; }

  /// Appends a text. Throws.
  void write(std::string_view text);

  /// Puts what was written onto the disk and gives it its name.
  void finish();

 private:
  std::filesystem::path path_;
  std::filesystem::path part_;
  int file_ = -1;
};

/// Writes a text as a new file, whole or not at all. Throws as NewFile.
void write_new_file(const std::filesystem::path& path, std::string_view text);

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/support/new_file.ipp>
#endif
