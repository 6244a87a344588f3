// SPDX-License-Identifier: MIT
// checkpoint.bin: the state from which a run can be resumed, with its provenance and a checksum.
#pragma once

#include <filesystem>
#include <trophic/params/archive.hpp>

namespace trophic::checkpoint {

/// The version of a checkpoint file's format.
inline constexpr std::uint32_t format_version = 7;

/// In bytes; larger than any manifest. The parsed content takes many times as much memory.
inline constexpr std::uint64_t largest_manifest = std::uint64_t{16} << 20U;

inline constexpr std::string_view file_name = "checkpoint.bin";
/// The previous checkpoint, in case the last one cannot be read.
inline constexpr std::string_view predecessor_name = "checkpoint.old.bin";

/// The part of a checkpoint that an object writes and reads. Refers to the object.
struct Part {
  std::string_view section;
  std::function<void(Archive& archive)> persist;
};
using Parts = std::vector<Part>;

/// The bytes of such a part.
struct Section {
  std::string name;
  std::string bytes;
  static constexpr auto saved() { return std::tuple{&Section::name, &Section::bytes}; }
};

/// A moment of a run.
struct Checkpoint {
  std::string fingerprint;      ///< observe::fingerprint of the run: rules, parameters, models, backend
  std::string program_version;  ///< trophic's version; only the same version continues to the same bytes
  std::string code = {};        ///< code of the program that wrote it, as from program_code()
  std::uint64_t seed = 0;
  std::int64_t tick = 0;
  double time_s = 0.0;  ///< the ecology's clock
  std::vector<Section> sections;

  static constexpr auto saved() {
    return std::tuple{&Checkpoint::fingerprint, &Checkpoint::program_version, &Checkpoint::code,    &Checkpoint::seed,
                      &Checkpoint::tick,        &Checkpoint::time_s,          &Checkpoint::sections};
  }

  /// The bytes of a section. Throws std::invalid_argument if there is no section with that name.
  [[nodiscard]] const std::string& section(std::string_view name) const {
    for (const Section& section : sections) {
      if (section.name == name) return section.bytes;
    }
    throw std::invalid_argument{"the checkpoint has no section \"" + std::string{name} +
                                "\": the run was made without it, so it must continue without it"};
  }
};

/// The checkpoint in a file's bytes. `name` names the bytes in errors. Throws std::invalid_argument for bytes that are not a
/// checkpoint, have a different format, or are cut short or damaged.
[[nodiscard]] Checkpoint from_bytes(std::string_view bytes, const std::string& name);

/// Writes checkpoint.bin in a folder: a line that names the format, its version, the content with `parts` after the sections of
/// `moment`, and the CRC-32 of it all. Parts are never in memory as a whole. The file is written next to the old one; the old one
/// remains as its predecessor. If the program dies at any moment, one of them is complete. Throws std::runtime_error.
void write(const std::filesystem::path& folder, Checkpoint moment, const Parts& parts = {});

/// Whether there is a checkpoint in a folder, complete or not.
[[nodiscard]] inline bool exists(const std::filesystem::path& folder) {
  return std::filesystem::exists(folder / file_name) || std::filesystem::exists(folder / predecessor_name);
}

/// Reads checkpoint.bin, or its predecessor if it is missing or damaged; a damaged one is then removed. Throws
/// std::invalid_argument with the error of the last one if neither is complete; UnreadableFile if the system cannot read one.
[[nodiscard]] Checkpoint read_last(const std::filesystem::path& folder);

/// All complete checkpoints, the last one first. Skips others without an exception; throws UnreadableFile.
[[nodiscard]] std::vector<Checkpoint> read_all(const std::filesystem::path& folder);

}  // namespace trophic::checkpoint

#if TROPHIC_HEADER_ONLY
#include <trophic/run/checkpoint/checkpoint_file.ipp>
#endif
