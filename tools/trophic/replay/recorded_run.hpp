// SPDX-License-Identifier: MIT
// A run's folder with its recording, checked to be of one run before anything is shown.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <tools/trophic/replay/own_tables.hpp>
#include <trophic/observe/read_recording.hpp>
#include <trophic/params/params.hpp>
#include <trophic/support/json.hpp>
#include <trophic/support/whole_file.hpp>
#include <utility>
#include <vector>

namespace trophic::command::replay {

/// What `show` and `film` look at.
struct RecordedRun {
  std::filesystem::path folder;
  Json manifest;
  observe::RecordingReader recording;
  std::vector<std::string> remarks;  ///< what is missing, a sentence each
};

/// Throws std::invalid_argument where no recording or manifest can be read or they are of different runs.
[[nodiscard]] inline Json read_manifest(const std::filesystem::path& folder, const observe::RecordingHead& head) {
  const std::filesystem::path path = folder / "manifest.json";
  auto manifest = parse_json_or_null(read_whole_file(path));
  if (!manifest.is_object()) throw std::invalid_argument{path.string() + ": cannot be read as a run's manifest"};
  try {
    const auto fingerprint = manifest.at("fingerprint").get<std::string>();
    const Json& seed = manifest.at("seed");
    if (fingerprint != head.fingerprint || seed != head.seed) {
      throw std::invalid_argument{path.string() + ": fingerprint " + fingerprint + ", seed " + json_text(seed) +
                                  ", but replay.trp beside it is of fingerprint " + head.fingerprint + ", seed " +
                                  std::to_string(head.seed) + "; they are of two runs"};
    }
  } catch (const Json::exception& error) {
    throw std::invalid_argument{path.string() + ": " + error.what()};
  }
  return manifest;
}

/// Opens a run's folder. Throws std::invalid_argument naming the file and what is wrong with it.
[[nodiscard]] inline RecordedRun open_run(const std::filesystem::path& folder) {
  if (!std::filesystem::is_directory(folder)) throw std::invalid_argument{folder.string() + ": is not a folder"};
  const std::filesystem::path path = folder / "replay.trp";
  if (!std::filesystem::exists(path)) {
    throw std::invalid_argument{path.string() + ": is not there; a run with --replay-hz 0 leaves none"};
  }
  try {
    observe::RecordingReader recording{path};
    auto manifest = read_manifest(folder, recording.head());
    if (manifest.value("agents_every_ticks", Json(1)) != 1) {
      throw std::invalid_argument{(folder / "agents.csv").string() + ": has the ticks that are multiples of " +
                                  json_text(manifest["agents_every_ticks"]) +
                                  ": must have all to be shown, as with --agents-every 1"};
    }
    RecordedRun run{folder, std::move(manifest), std::move(recording), {}};
    if (!run.recording.remark().empty()) run.remarks.push_back(run.recording.remark());
    check_own_tables(folder, run.recording, run.manifest);
    return run;
  } catch (const Json::exception& error) {
    throw std::invalid_argument{(folder / "manifest.json").string() + ": " + error.what()};
  } catch (const std::runtime_error& error) {
    throw std::invalid_argument{error.what()};
  }
}

/// A stretch of the ecology's clock; without a bound from the first or to the last recorded moment.
struct Window {
  std::optional<double> from_s;
  std::optional<double> to_s;

  /// Throws std::invalid_argument for a window outside the recording or that ends before it begins.
  void check(const observe::RecordingReader& recording) const {
    if (from_s) static_cast<void>(recording.frame_at(*from_s));
    if (to_s) static_cast<void>(recording.frame_at(*to_s));
    if (from_s && to_s && !(*from_s <= *to_s)) {
      throw std::invalid_argument{"--from " + number_text(*from_s) + ": must be <= --to, " + number_text(*to_s)};
    }
  }
  [[nodiscard]] double start_s(const observe::RecordingReader& recording) const {
    return from_s.value_or(recording.head().first_time_s);
  }
  [[nodiscard]] double end_s(const observe::RecordingReader& recording) const {
    return to_s.value_or(recording.time_s(recording.frames() - 1));
  }
  [[nodiscard]] bool has(double time_s) const { return !(from_s && time_s < *from_s - 1e-9) && !(to_s && time_s > *to_s + 1e-9); }
  /// Whether a tick tells who lives at a moment of the stretch: from the last one at or before its start on.
  [[nodiscard]] bool has_tick(double time_s, double tick_s) const {
    return !(from_s && time_s <= *from_s - tick_s + 1e-9) && !(to_s && time_s > *to_s + 1e-9);
  }
};

}  // namespace trophic::command::replay
