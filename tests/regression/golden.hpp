// SPDX-License-Identifier: MIT
// Whole runs against files that were written by an earlier version.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <trophic/params/named_params.hpp>
#include <trophic/support/json.hpp>
#include <trophic/support/whole_file.hpp>

namespace trophic::test {

using FileLines = std::vector<std::string>;

[[nodiscard]] inline FileLines lines_of(const std::filesystem::path& path) {
  std::ifstream file{path, std::ios::binary};
  if (!file) throw std::runtime_error{path.string() + ": cannot be read"};
  FileLines lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

inline void write_lines(const std::filesystem::path& path, const FileLines& lines) {
  std::ofstream file{path, std::ios::binary};
  for (const std::string& line : lines) file << line << '\n';
  if (!file.flush()) throw std::runtime_error{path.string() + ": cannot be written"};
}

/// An empty folder of that name for a run's new files, in the build folder.
[[nodiscard]] inline std::filesystem::path written_folder(const std::string& name) {
  const std::filesystem::path folder = std::filesystem::path{WRITTEN_DIR} / name;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder.parent_path());
  return folder;
}

/// Replaces agents.csv by agents.hash.csv, which is a hundredth of it: the header, then for each tick the hash of its rows.
inline void hash_agents(const std::filesystem::path& folder) {
  const FileLines rows = lines_of(folder / "agents.csv");
  FileLines hashed{"time_s,tick,hash of: " + rows.at(0)};
  const auto tick_of = [](const std::string& row) { return row.substr(0, row.find(',', row.find(',') + 1)); };
  for (std::size_t first = 1; first < rows.size();) {
    std::string tick;
    std::size_t next = first;
    while (next < rows.size() && tick_of(rows[next]) == tick_of(rows[first])) tick += rows[next++] + '\n';
    hashed.push_back(tick_of(rows[first]) + "," + hash_text(tick));
    first = next;
  }
  write_lines(folder / "agents.hash.csv", hashed);
  std::filesystem::remove(folder / "agents.csv");
}

/// The golden files are those of a recorded run; the recording itself holds against its own tests.
inline void remove_recording(const std::filesystem::path& folder) {
  if (!std::filesystem::remove(folder / "replay.trp")) throw std::runtime_error{folder.string() + ": has no recording"};
}

/// Takes out of manifest.json what names the version, the compiler and the source rather than the run, and the sums of the
/// tables, which are compared themselves.
inline void strip_manifest(const std::filesystem::path& folder) {
  auto manifest = parse_json(read_whole_file(folder / "manifest.json"));
  for (const char* key :
       {"format", "crc32", "trophic", "compiler", "architecture", "c_library", "source", "code", "tables", "recording"})
    manifest.erase(key);
  std::istringstream text{json_text(manifest, 1)};
  FileLines lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  write_lines(folder / "manifest.json", lines);
}

/// The names of a folder's files in order; none where there is no folder.
[[nodiscard]] inline FileLines names_in(const std::filesystem::path& folder) {
  FileLines names;
  if (!std::filesystem::exists(folder)) return names;
  for (const auto& entry : std::filesystem::directory_iterator{folder}) names.push_back(entry.path().filename());
  std::ranges::sort(names);
  return names;
}

[[nodiscard]] inline std::string joined(const FileLines& names) {
  std::string text;
  for (const std::string& name : names) text += name + " ";
  return text;
}

/// Holds every file of golden/NAME against the one of the same name that was written now, line by line, and the other way round.
/// A test that fails prints the first three lines that differ in each file.
inline void check_golden(const std::string& name) {
  const std::filesystem::path golden = std::filesystem::path{GOLDEN_DIR} / name;
  const std::filesystem::path written = std::filesystem::path{WRITTEN_DIR} / name;
  const FileLines files = names_in(written);
  INFO("the new files are in " << written.string());
  CHECK(joined(names_in(golden)) == joined(files));
  for (const std::string& file : files) {
    if (!std::filesystem::exists(golden / file)) continue;
    const FileLines before = lines_of(golden / file);
    const FileLines now = lines_of(written / file);
    std::string report;
    std::size_t differing = 0;
    for (std::size_t i = 0; i < std::max(before.size(), now.size()); ++i) {
      const std::string one = i < before.size() ? before[i] : "(none)";
      const std::string two = i < now.size() ? now[i] : "(none)";
      if (one == two || ++differing > 3) continue;
      report += "line " + std::to_string(i + 1) + "\n  golden: " + one + "\n  now:    " + two + "\n";
    }
    INFO(name << "/" << file << ": " << differing << " lines differ, the first:\n" << report);
    CHECK(differing == 0);
  }
}

}  // namespace trophic::test
