// SPDX-License-Identifier: MIT
// Replaces a file as a whole: readers see the old text or the new one, even if the program dies.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>
#include <trophic/support/linkage.hpp>

namespace trophic {

/// Writes a text at an offset in a file.
using PutText = std::function<void(std::string_view text, std::uint64_t at)>;

/// Fills a new file "PATH.part" by `write`, then renames it; targets of links with either name are not changed. Both the text and
/// the name are on the disk when this returns, so even a power failure leaves the old file or the new one. Throws
/// std::runtime_error naming the file; the old one then remains. The old file is kept under the name `predecessor`, if that is
/// not empty; if the program dies, this one may be the only one left.
void replace_file(const std::filesystem::path& path, const std::function<void(const PutText& put)>& write,
                  const std::filesystem::path& predecessor = {});
inline void replace_file(const std::filesystem::path& path, std::string_view text) {
  replace_file(path, [text](const PutText& put) { put(text, 0); });
}

/// Waits until the content written to a file is on the disk. Throws std::runtime_error naming it.
void sync_file(const std::filesystem::path& path);

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/support/replace_file.ipp>
#endif
