// SPDX-License-Identifier: MIT
// Reads replay.trp: the pose of every robot at any recorded moment, without the engine.
#pragma once

#include <deque>
#include <filesystem>
#include <span>
#include <trophic/habitat/arena.hpp>
#include <trophic/habitat/pose.hpp>
#include <trophic/habitat/robot_model.hpp>
#include <trophic/io/recording_format.hpp>
#include <trophic/observe/frame.hpp>

namespace trophic::io {

/// The head of a recording before its first frame, with the run of its last head.
struct RecordingHead {
  std::string fingerprint;  ///< of the run
  std::uint64_t seed = 0;
  std::string rule_table;
  std::string backend;
  std::vector<std::string> species;
  double first_time_s = 0.0;  ///< of frame 0, ecology seconds
  observe::FrameTimes times;
  std::int64_t frames_per_tick = 1;
  std::size_t robots = 0;
  std::size_t joints = 0;      ///< of each robot; in a run whose bodies differ, the most of its first frame
  bool bodies_differ = false;  ///< whether robots have bodies of their own: RecordingReader::robot
  recording::Units units;
  RobotModel robot;  ///< the habitat's: its appearance and kinematics: links, boxes, the hinges' names and axes
  Arena arena;
};

/// A recording as a file of frames. Blocks are read on demand; the last ones are kept, as many as have
/// `most_kept_values` numbers.
class RecordingReader {
 public:
  static constexpr std::size_t most_kept_values = std::size_t{1} << 26U;

  /// Reads the head and checks every block. Throws std::runtime_error naming the file for one that cannot be read, is not a
  /// recording, is of another version or is damaged. A file that ends early, as a killed run leaves it, has the frames of its
  /// whole blocks.
  explicit RecordingReader(std::filesystem::path path);

  [[nodiscard]] const RecordingHead& head() const { return head_; }
  [[nodiscard]] std::size_t frames() const { return frames_; }
  /// One sentence if the file ends early, else empty.
  [[nodiscard]] const std::string& remark() const { return remark_; }

  /// The ecology's clock at a frame.
  [[nodiscard]] double time_s(std::size_t frame) const;
  /// The last frame at or before a moment. Throws std::invalid_argument for a moment outside the recording.
  [[nodiscard]] std::size_t frame_at(double time_s) const;

  /// The body of a robot at a frame. Throws std::out_of_range for one that the recording lacks.
  [[nodiscard]] const RobotModel& robot(std::size_t frame, std::size_t robot) const;
  /// All bodies of the recording: one, or those of the robots of a run whose bodies differ.
  [[nodiscard]] std::span<const RobotModel> bodies() const;
  /// The number of a robot's body in `bodies` at a frame.
  [[nodiscard]] std::size_t body(std::size_t frame, std::size_t robot) const;
  /// Whether a robot's body was set down anew between the frame before and this one, so that nothing moved in between.
  [[nodiscard]] bool is_set_down(std::size_t frame, std::size_t robot) const;

  /// Throws std::out_of_range for a frame, robot or joint that the recording lacks.
  [[nodiscard]] Pose root(std::size_t frame, std::size_t robot) const;
  [[nodiscard]] double joint_angle_rad(std::size_t frame, std::size_t robot, std::size_t joint) const;

 private:
  struct Block {
    std::size_t first_frame = 0;
    std::size_t frames = 0;
    std::streamoff at = 0;  ///< of the compressed bytes
    std::size_t bytes = 0;
    std::size_t channels = 0;
  };
  /// A robot has a body from a frame on.
  struct SetDown {
    std::size_t frame = 0;
    std::size_t body = 0;
  };

  void scan();
  void read_head(const std::string& text);
  void read_body(const std::string& text);
  /// Returns false for a block that is not of this recording.
  [[nodiscard]] bool read_set_down(const std::string& data);
  [[nodiscard]] std::int16_t value(std::size_t frame, std::size_t robot, std::size_t channel) const;
  void unpack(std::size_t block) const;

  std::filesystem::path path_;
  RecordingHead head_;
  std::vector<Block> blocks_;
  std::size_t frames_ = 0;
  std::vector<RobotModel> bodies_;              ///< if they differ
  std::vector<std::vector<SetDown>> set_down_;  ///< of each robot, if bodies differ
  std::string remark_;
  mutable std::vector<std::vector<std::int16_t>> unpacked_;  ///< by block; those that are not kept are empty
  mutable std::deque<std::size_t> kept_;                     ///< the blocks that are, the oldest first
  mutable std::size_t kept_values_ = 0;
};

}  // namespace trophic::io
