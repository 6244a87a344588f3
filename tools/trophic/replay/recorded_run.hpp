// SPDX-License-Identifier: MIT
// A run's folder with its recording, checked to be of one run before anything is shown.
#pragma once

#include <filesystem>
#include <optional>
#include <tools/recording/read_recording.hpp>
#include <trophic/support/json.hpp>
#include <vector>

namespace trophic::command::replay {

/// A run as `show` and `film` read it.
struct RecordedRun {
  std::filesystem::path folder;
  Json manifest;
  io::RecordingReader recording;
  std::vector<std::string> remarks;  ///< what is missing, a sentence each
};

/// Throws std::invalid_argument where no recording or manifest can be read or they are of different runs.
[[nodiscard]] Json read_manifest(const std::filesystem::path& folder, const io::RecordingHead& head);

/// The sentence about a folder that is not a run, with the runs and sets of replicates in it.
[[nodiscard]] std::string runs_in(const std::filesystem::path& folder);

/// Opens a run's folder. Throws std::invalid_argument naming the file and what is wrong with it.
[[nodiscard]] RecordedRun open_run(const std::filesystem::path& folder);

/// A stretch of the ecology's clock; without a bound from the first or to the last recorded moment.
struct Window {
  std::optional<double> from_s;
  std::optional<double> to_s;

  /// Throws std::invalid_argument for a window outside the recording or that ends before it begins.
  void check(const io::RecordingReader& recording) const;
  [[nodiscard]] double start_s(const io::RecordingReader& recording) const;
  [[nodiscard]] double end_s(const io::RecordingReader& recording) const;
  [[nodiscard]] bool has(double time_s) const { return !(from_s && time_s < *from_s - 1e-9) && !(to_s && time_s > *to_s + 1e-9); }
  /// Whether a tick determines the individuals at a moment of the stretch: the last tick at or before its start, and later ones.
  [[nodiscard]] bool has_tick(double time_s, double tick_s) const;
};

}  // namespace trophic::command::replay
