// SPDX-License-Identifier: MIT
// The text of a file, without waiting for what is no file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <trophic/support/linkage.hpp>

namespace trophic {

/// More than any file of trophic's that is read as a whole.
inline constexpr std::uint64_t largest_whole_file = std::uint64_t{256} << 20U;

/// Everything in a file. Throws std::invalid_argument "PATH: ..." where nothing can be read, where it is no regular file (a pipe
/// would be waited for) and where it is larger than `most_bytes`.
[[nodiscard]] std::string read_whole_file(const std::filesystem::path& path, std::uint64_t most_bytes = largest_whole_file);

/// The first bytes of a file, as many as there are. Throws as read_whole_file, whatever the file's size.
[[nodiscard]] std::string read_beginning(const std::filesystem::path& path, std::size_t bytes);

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/support/whole_file.ipp>
#endif
