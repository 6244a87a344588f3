// SPDX-License-Identifier: MIT
// A new folder for results, which gets its final name when they are complete.
#pragma once

#include <system_error>
#include <trophic/io/run_folder.hpp>
#include <trophic/support/no_links.hpp>
#include <trophic/support/without_slash.hpp>

namespace trophic::command {

/// The folder PATH.part. The constructor removes the files that a killed program left in it, except `kept`; the destructor does
/// so unless the folder has its name.
class ResultFolder {
 public:
  /// Throws std::invalid_argument if PATH exists, std::runtime_error if another program works in PATH.part.
  explicit ResultFolder(const std::filesystem::path& out, std::string kept = {})
      : out_{without_slash(out)}, path_{made(out_)}, kept_{std::move(kept)}, lock_{path_} {
    clear();
  }
  ResultFolder(const ResultFolder&) = delete;
  ResultFolder& operator=(const ResultFolder&) = delete;
  ~ResultFolder() {
    std::error_code ignored;
    if (is_published_) return;
    clear();
    std::filesystem::remove(path_, ignored);
  }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  /// Gives the folder its name.
  void publish() {
    io::check_new_folder(out_);
    std::filesystem::rename(path_, out_);
    is_published_ = true;
  }

 private:
  [[nodiscard]] static std::filesystem::path made(const std::filesystem::path& out) {
    io::check_new_folder(out);
    const std::filesystem::path path = out.string() + ".part";
    check_no_link(path);
    return std::filesystem::is_directory(path) ? path : io::make_new_folder(path);
  }

  void clear() const {
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator{path_, ignored}) {
      if (entry.path().filename() != kept_) std::filesystem::remove_all(entry.path(), ignored);
    }
  }

  std::filesystem::path out_;
  std::filesystem::path path_;
  std::string kept_;
  FolderLock lock_;
  bool is_published_ = false;
};

}  // namespace trophic::command
