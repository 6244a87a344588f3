// SPDX-License-Identifier: MIT
// Replaces a file as a whole: readers see the old text or the new one, also if the program dies.
#pragma once

#include <filesystem>
#include <string_view>
#include <trophic/support/linkage.hpp>

namespace trophic {

/// Writes `text` to "PATH.part", then renames it. When this returns, both the text and the name are on the disk, so that a
/// power failure also leaves the old file or the new one. Throws std::runtime_error naming the file, and keeps the old one. If
/// `predecessor` is not empty, the old file is kept under that name; a program that dies may leave only this one.
void replace_file(const std::filesystem::path& path, std::string_view text, const std::filesystem::path& predecessor = {});

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/support/replace_file.ipp>
#endif
