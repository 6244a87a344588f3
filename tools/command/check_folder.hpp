// SPDX-License-Identifier: MIT
// Refuses a path that does not lead to a folder, with the reason.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace trophic {

/// Throws std::invalid_argument "PATH: ..." unless a path leads to a folder.
inline void check_folder(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (std::filesystem::is_directory(status)) return;
  if (status.type() == std::filesystem::file_type::not_found) throw std::invalid_argument{path.string() + ": does not exist"};
  if (error) throw std::invalid_argument{path.string() + ": cannot be opened: " + error.message()};
  throw std::invalid_argument{path.string() + ": is not a folder"};
}

}  // namespace trophic
