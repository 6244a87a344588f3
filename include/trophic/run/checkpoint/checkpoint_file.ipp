// SPDX-License-Identifier: MIT
// Definitions of checkpoint_file.hpp.
#pragma once

#include <cerrno>
#include <cstdio>
#include <system_error>
#include <trophic/run/checkpoint/checkpoint_file.hpp>
#include <trophic/support/checksum.hpp>
#include <trophic/support/replace_file.hpp>
#include <trophic/support/unreadable_file.hpp>
#include <trophic/support/whole_file.hpp>

namespace trophic::checkpoint {

namespace detail {

/// Room for ten million robots.
inline constexpr std::uint64_t largest_file = std::uint64_t{64} << 30U;

inline constexpr std::string_view first_line = "trophic checkpoint\n";

/// The bytes of a checkpoint file. Its beginning is looked at first: the file may be anything, of any size.
[[nodiscard]] inline std::string read_bytes(const std::filesystem::path& path) {
  const std::string beginning = read_beginning(path, first_line.size());
  if (!beginning.starts_with(first_line)) throw std::invalid_argument{path.string() + ": is not a checkpoint of trophic"};
  return read_whole_file(path, largest_file);
}

}  // namespace detail

TROPHIC_INLINE std::string to_bytes(Checkpoint checkpoint) {
  Archive archive;
  std::uint32_t version = format_version;
  archive(version, checkpoint);
  std::string bytes{detail::first_line};
  bytes += archive.bytes();
  Archive sum;
  std::uint32_t crc = checksum(bytes);
  sum(crc);
  bytes += sum.bytes();
  return bytes;
}

TROPHIC_INLINE Checkpoint from_bytes(std::string_view bytes, const std::string& name) {
  const auto require = [&](bool good, const std::string& why) {
    if (!good) throw std::invalid_argument{name + ": " + why};
  };
  require(bytes.starts_with(detail::first_line), "is not a checkpoint of trophic");
  const std::string_view all = bytes;
  bytes.remove_prefix(detail::first_line.size());
  std::uint32_t version = 0;
  std::uint32_t crc = 0;
  require(bytes.size() >= sizeof(version) + sizeof(crc), "is cut short");
  Archive{bytes.substr(0, sizeof(version))}(version);
  bytes.remove_prefix(sizeof(version));
  require(version == format_version, "has format " + std::to_string(version) +
                                         (version > format_version ? ", of a newer version of trophic" : "") + ": must be " +
                                         std::to_string(format_version) + ", as this program writes");
  Archive{bytes.substr(bytes.size() - sizeof(crc))}(crc);
  require(crc == checksum(all.substr(0, all.size() - sizeof(crc))), "is cut short or damaged: its checksum is another");
  bytes.remove_suffix(sizeof(crc));
  Checkpoint checkpoint;
  try {
    Archive archive{bytes};
    archive(checkpoint);
    archive.finish();
  } catch (const std::invalid_argument& error) {
    require(false, error.what());
  }
  return checkpoint;
}

TROPHIC_INLINE void write(const std::filesystem::path& folder, Checkpoint checkpoint) {
  const std::filesystem::path path = folder / file_name;
  const std::string bytes = to_bytes(std::move(checkpoint));
  replace_file(path, bytes, folder / predecessor_name);
}

TROPHIC_INLINE Checkpoint read_last(const std::filesystem::path& folder) {
  const auto read = [&](std::string_view name) {
    const std::filesystem::path path = folder / name;
    return from_bytes(detail::read_bytes(path), path.string());
  };
  try {
    return read(file_name);
  } catch (const UnreadableFile&) {
    throw;
  } catch (const std::invalid_argument&) {
    if (!std::filesystem::exists(folder / predecessor_name)) throw;
    Checkpoint before = read(predecessor_name);
    // Otherwise the next write would replace this one by the damaged one.
    std::error_code ignored;
    std::filesystem::remove(folder / file_name, ignored);
    return before;
  }
}

TROPHIC_INLINE std::vector<Checkpoint> read_all(const std::filesystem::path& folder) {
  std::vector<Checkpoint> found;
  for (const std::string_view name : {file_name, predecessor_name}) {
    try {
      found.push_back(from_bytes(detail::read_bytes(folder / name), std::string{name}));
    } catch (const UnreadableFile&) {
      throw;
    } catch (const std::invalid_argument&) {  // the other one may be whole
      continue;
    }
  }
  return found;
}

}  // namespace trophic::checkpoint
