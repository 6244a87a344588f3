// SPDX-License-Identifier: MIT
// Definitions of checkpoint_file.hpp.
#pragma once

#include <zlib.h>

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

/// The length of a checkpoint file of this format by the lengths in it, read one by one.
[[nodiscard]] inline std::uint64_t length_by_content(const std::filesystem::path& path) {
  constexpr std::uint64_t most_sections = 1000;
  std::uint64_t at = first_line.size() + sizeof(format_version);
  const auto number = [&](std::uint64_t most) {
    const std::string bytes = read_part(path, sizeof(std::uint64_t), at);
    std::uint64_t value = most + 1;
    if (bytes.size() == sizeof(value)) Archive{bytes}(value);
    if (value > most) throw std::invalid_argument{path.string() + ": is cut short or damaged"};
    at += sizeof(value);
    return value;
  };
  const auto pass_text = [&] { at += number(largest_file); };
  for (int i = 0; i < 3; ++i) pass_text();  // fingerprint, version, code
  at += sizeof(Checkpoint::seed) + sizeof(Checkpoint::tick) + sizeof(Checkpoint::time_s);
  for (std::uint64_t left = 2 * number(most_sections); left > 0; --left) pass_text();
  return at + sizeof(std::uint32_t);
}

/// The bytes of a checkpoint file. Its beginning and its lengths are checked first, because the file may be anything, of any
/// size.
[[nodiscard]] inline std::string read_bytes(const std::filesystem::path& path) {
  std::string beginning = read_part(path, first_line.size() + 2 * sizeof(format_version));
  if (!beginning.starts_with(first_line)) throw std::invalid_argument{path.string() + ": is not a checkpoint of trophic"};
  std::uint32_t format = 0;
  if (beginning.size() == first_line.size() + 2 * sizeof(format))
    Archive{std::string_view{beginning}.substr(first_line.size())}(format);
  if (format != format_version) return beginning;  // from_bytes says why
  const std::uint64_t length = length_by_content(path);
  if (const std::uint64_t bytes = std::filesystem::file_size(path); bytes != length) {
    throw std::invalid_argument{path.string() + ": is cut short or damaged: it has " + std::to_string(bytes) +
                                " bytes: must be " + std::to_string(length) + ", by its content"};
  }
  return read_whole_file(path, length);
}

}  // namespace detail

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

TROPHIC_INLINE void write(const std::filesystem::path& folder, Checkpoint moment, const Parts& parts) {
  const auto fill = [&](const PutText& put) {
    std::uint64_t length = 0;
    std::uint32_t sum = 0;
    const auto append = [&](std::string_view bytes) {
      put(bytes, std::exchange(length, length + bytes.size()));
      sum = checksum(bytes, sum);
    };
    append(detail::first_line);
    Archive archive{append};
    std::uint32_t version = format_version;
    std::uint64_t sections = moment.sections.size() + parts.size();
    archive(version, moment.fingerprint, moment.program_version, moment.code, moment.seed, moment.tick, moment.time_s, sections);
    for (Section& section : moment.sections) archive(section);
    for (const Part& part : parts) {
      std::string name{part.section};
      archive(name);
      archive.finish();
      const std::uint32_t before = std::exchange(sum, 0);
      const std::uint64_t at = std::exchange(length, length + sizeof(length));
      Archive section{append};
      part.persist(section);
      section.finish();
      Archive number;  // its length, which stands before it
      std::uint64_t size = length - at - sizeof(length);
      number(size);
      put(number.bytes(), at);
      sum = static_cast<std::uint32_t>(crc32_combine(checksum(number.bytes(), before), sum, static_cast<z_off_t>(size)));
    }
    archive.finish();
    archive(sum);
    archive.finish();
  };
  replace_file(folder / file_name, fill, folder / predecessor_name);
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
    // Otherwise the next write would replace this one with the damaged one.
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
