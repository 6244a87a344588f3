// SPDX-License-Identifier: MIT
// replay.trp: poses of all robots and their joints, several times per second, small enough to keep for every run.
#pragma once

#include <filesystem>
#include <trophic/io/growing_file.hpp>
#include <trophic/io/recording_format.hpp>
#include <trophic/observe/frame.hpp>
#include <trophic/observe/run_description.hpp>
#include <trophic/population/view.hpp>
#include <trophic/support/linkage.hpp>

namespace trophic::io {

/// Frames per simulated second: enough to show a gait (0.34 Hz for the spider's), at a cost of 9 MB for 6000 s with 30 robots.
inline constexpr double default_replay_hz = 5.0;

/// Writes a recording: root poses to 1 mm and 2e-3 rad, joint angles to 2e-3 rad. Events are in the run's tables. A block of 20
/// s, or of as many frames as fit in `most_block_values` numbers, is written as soon as it is full, so a killed run loses at most
/// one block, and a large run holds only one in memory. A run that starts at a moment of another one (--from) adds its own
/// header. Observes one call of run_until. Errors are std::runtime_error naming the file.
class Recording {
 public:
  /// Makes the file at once. `hz`: frames per simulated second, >= 0; at 0 there are no file and no frames. Throws
  /// std::invalid_argument for an invalid rate. With `Opening::resumed` the file exists if the run has one; call `persist` next:
  /// the recording continues at its original rate.
  Recording(const std::filesystem::path& path, double hz, Opening opening = Opening::created);
  Recording(Recording&&) noexcept = default;
  Recording& operator=(Recording&&) noexcept = default;

  /// Writes or reads the rate, the file's length and the frames that wait for their block. Reading throws std::invalid_argument
  /// if the run had a recording and the folder has none.
  void persist(Archive& archive);

  static constexpr std::size_t most_block_values = std::size_t{1} << 22U;

  [[nodiscard]] double frame_hz() const { return hz_; }
  /// The number of frames.
  [[nodiscard]] std::uint64_t frames() const { return frames_; }
  /// CRC-32 of the file as written so far; 0 without a file.
  [[nodiscard]] std::uint32_t checksum() const;
  void on_start(const observe::RunDescription& run, const View& view);
  void on_frame(const observe::Frame& frame);
  void on_end(const View& view);
  /// Keeps the frames before the failure; the file has no end.
  void on_failure(std::string_view what);

 private:
  struct File;

  void write_head(const observe::Frame& frame);
  void write_bodies(const observe::Frame& frame);
  void write_frames();
  [[nodiscard]] std::string waiting() const;

  double hz_;
  std::shared_ptr<File> file_;  ///< this object alone owns it
  recording::Units units_;
  std::size_t channels_ = 0;  ///< channels per robot; if bodies differ, those of the one with the most joints so far
  std::size_t robots_ = 0;
  std::size_t block_frames_ = 0;
  std::string fingerprint_;   ///< of the run that the last header names
  std::uint64_t seed_ = 0;    ///< of that run
  std::uint32_t frames_ = 0;  ///< written or waiting
  bool bodies_differ_ = false;
  std::vector<std::string> bodies_;        ///< hashes of the BODY blocks
  std::vector<std::uint64_t> individual_;  ///< individual for which each robot's body was last put in place
  std::vector<std::int16_t> values_;       ///< values of the waiting frames: frame by frame, robot by robot, channel by channel
};

}  // namespace trophic::io

#if TROPHIC_HEADER_ONLY
#include <trophic/io/recording.ipp>
#endif
