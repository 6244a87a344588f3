// SPDX-License-Identifier: MIT
// Reads the text of a regular file; never blocks on other kinds of files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <trophic/support/linkage.hpp>

namespace trophic {

/// Larger than any file that trophic reads as a whole.
inline constexpr std::uint64_t largest_whole_file = std::uint64_t{256} << 20U;

/// Returns the content of a file. Throws std::invalid_argument "PATH: ..." if it cannot be read, is not a regular file (reading
/// a pipe could block) or is larger than `most_bytes`.
[[nodiscard]] std::string read_whole_file(const std::filesystem::path& path, std::uint64_t most_bytes = largest_whole_file);

/// Returns the bytes of a file from an offset on, as many as there are. Throws as read_whole_file does, whatever the file's size.
[[nodiscard]] std::string read_part(const std::filesystem::path& path, std::size_t bytes, std::uint64_t from = 0);

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/support/whole_file.ipp>
#endif
