// SPDX-License-Identifier: MIT
// A file that gets its name only when it is complete: a killed program leaves no file that looks complete.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <trophic/support/linkage.hpp>

namespace trophic {

/// A new file that is written as "PATH.part". The remains of a killed program are overwritten. Errors are std::runtime_error
/// naming the file.
class NewFile {
 public:
  /// Throws if the name exists, if the system cannot create a file in the folder, or if another program is writing it.
  explicit NewFile(std::filesystem::path path);
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;
  /// Removes a file that was not finished.
  ~NewFile();

  /// The final name.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// The name until then.
  [[nodiscard]] const std::filesystem::path& part() const { return part_; }
  /// A path by which another program can open this file during this object's lifetime, even if its name refers to another file by
  /// then.
  [[nodiscard]] std::string opened_again() const;

  /// Appends a text. Throws.
  void write(std::string_view text);

  /// Writes the content to the disk and gives the file its final name. Throws if that name is taken meanwhile.
  void finish();

 private:
  std::filesystem::path path_;
  std::filesystem::path part_;
  int file_ = -1;
};

/// Writes a text as a new file, completely or not at all. Throws as NewFile.
void write_new_file(const std::filesystem::path& path, std::string_view text);

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/support/new_file.ipp>
#endif
