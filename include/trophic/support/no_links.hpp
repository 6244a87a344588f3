// SPDX-License-Identifier: MIT
// Rejects links in place of folders and files, because a program that writes to a link writes elsewhere.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <trophic/support/without_slash.hpp>

namespace trophic {

/// Throws std::invalid_argument if the path itself is a symbolic link. The folders above it may be links.
inline void check_no_link(const std::filesystem::path& path) {
  if (!std::filesystem::is_symlink(std::filesystem::symlink_status(without_slash(path)))) return;
  throw std::invalid_argument{path.string() +
                              ": is a symbolic link: must be a real file or folder, or output would be written elsewhere"};
}

/// Throws std::invalid_argument if a folder contains a symbolic link or a file with a second name.
inline void check_no_links_in(const std::filesystem::path& folder) {
  for (const auto& entry : std::filesystem::directory_iterator{folder}) {
    check_no_link(entry.path());
    if (!entry.is_regular_file() || entry.hard_link_count() == 1) continue;
    throw std::invalid_argument{
        entry.path().string() +
        ": has a second name (a hard link): must have only one, or a file elsewhere would change with it"};
  }
}

}  // namespace trophic
