// SPDX-License-Identifier: MIT
// Names of folders without a trailing slash.
#pragma once

#include <filesystem>
#include <trophic/support/cpp20.hpp>

namespace trophic {

/// "runs/a" for "runs/a/" and "runs/a", so that a suffix can be appended.
[[nodiscard]] inline std::filesystem::path without_slash(const std::filesystem::path& folder) {
  return folder.has_filename() ? folder : folder.parent_path();
}

}  // namespace trophic
