// SPDX-License-Identifier: MIT
// A name for the folder of the next run.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <trophic/support/cpp20.hpp>

namespace trophic::io {

/// The first of PATH-1, PATH-2, ... that does not exist, so a program that is started twice has two folders.
[[nodiscard]] inline std::filesystem::path next_free_folder(const std::filesystem::path& path) {
  for (std::size_t number = 1;; ++number) {
    std::filesystem::path numbered = path;
    numbered += "-" + std::to_string(number);
    if (!std::filesystem::exists(std::filesystem::symlink_status(numbered))) return numbered;
  }
}

}  // namespace trophic::io
