// SPDX-License-Identifier: MIT
// A new folder for results, which goes again if the work fails.
#pragma once

#include <system_error>
#include <trophic/io/run_folder.hpp>

namespace trophic::command {

class ResultFolder {
 public:
  /// Makes it. Throws std::invalid_argument if it exists.
  explicit ResultFolder(const std::filesystem::path& path) : path_{io::make_new_folder(path)} {}
  ResultFolder(const ResultFolder&) = delete;
  ResultFolder& operator=(const ResultFolder&) = delete;
  ~ResultFolder() {
    std::error_code ignored;
    if (!is_kept_) std::filesystem::remove(path_, ignored);
  }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  void keep() { is_kept_ = true; }

 private:
  std::filesystem::path path_;
  bool is_kept_ = false;
};

}  // namespace trophic::command
