// SPDX-License-Identifier: MIT
// Folders that are named with a slash at their end.
#pragma once

#include <filesystem>

namespace trophic {

/// "runs/a" for "runs/a/" and "runs/a": what something can be put behind.
[[nodiscard]] inline std::filesystem::path without_slash(const std::filesystem::path& folder) {
  return folder.has_filename() ? folder : folder.parent_path();
}

}  // namespace trophic
