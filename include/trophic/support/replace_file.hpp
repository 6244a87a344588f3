// SPDX-License-Identifier: MIT
// Replaces a file as a whole: a reader, or a program that dies meanwhile, sees the old text or the new one.
#pragma once

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace trophic::detail {

/// Writes `text` beside `path`, then renames it. Throws std::runtime_error naming the file.
inline void replace_file(const std::filesystem::path& path, std::string_view text) {
  const std::filesystem::path temporary = path.string() + ".part";
  std::ofstream file{temporary, std::ios::binary};
  file << text;
  file.close();
  if (!file) throw std::runtime_error{"cannot write " + path.string() + ": " + std::strerror(errno)};
  std::filesystem::rename(temporary, path);
}

}  // namespace trophic::detail
