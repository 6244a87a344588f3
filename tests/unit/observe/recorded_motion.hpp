// SPDX-License-Identifier: MIT
// A made up motion of three robots and its recording.
#pragma once

#include <doctest/doctest.h>

#include <iterator>
#include <support/temporary_folder.hpp>
#include <tools/recording/read_recording.hpp>
#include <trophic/io/recording.hpp>
#include <trophic/population/food_web.hpp>
#include <trophic/support/rng.hpp>

namespace trophic::test {

inline constexpr std::size_t robots = 3;
inline constexpr std::size_t joints = 2;

/// Robots that wander, turn over and bend, one frame after another.
struct Motion {
  std::vector<std::vector<Pose>> roots;
  std::vector<std::vector<double>> angles_rad;

  explicit Motion(std::size_t frames) {
    Rng rng{7, Stream::placement};
    std::vector<Pose> now(robots);
    std::vector<double> bent(robots * joints);
    for (std::size_t frame = 0; frame < frames; ++frame) {
      for (Pose& pose : now) {
        pose.position_m += 0.02 * Eigen::Vector3d{rng.normal(0.0, 1.0), rng.normal(0.0, 1.0), 0.1 * rng.normal(0.0, 1.0)};
        const Eigen::Vector3d axis =
            Eigen::Vector3d{rng.normal(0.0, 1.0), rng.normal(0.0, 1.0), rng.normal(0.0, 1.0)}.normalized();
        pose.orientation =
            (pose.orientation * Eigen::Quaterniond{Eigen::AngleAxisd{0.3 * rng.normal(0.0, 1.0), axis}}).normalized();
      }
      for (double& angle : bent) angle = std::clamp(angle + 0.1 * rng.normal(0.0, 1.0), -1.0, 1.0);
      roots.push_back(now);
      angles_rad.push_back(bent);
    }
  }
};

[[nodiscard]] inline RobotModel two_joints() {
  RobotModel robot;
  robot.name = "bent";
  robot.bounding_radius_m = 0.3;
  robot.links.resize(joints + 1);
  robot.hinges.resize(joints);
  for (std::size_t link = 1; link <= joints; ++link) {
    robot.links[link].parent = static_cast<int>(link) - 1;
    robot.links[link].offset_m = {0.1, 0.02, 0.003};
    robot.links[link].boxes.push_back({.part = "arm", .half_extents_m = {0.1, 0.2, 0.3}});
    robot.hinges[link - 1].axis = Eigen::Vector3d::UnitX();
  }
  return robot;
}

inline const RobotModel& robot_model() {
  static const RobotModel robot = two_joints();
  return robot;
}

inline void record(const std::filesystem::path& path, const Motion& motion, bool to_the_end = true) {
  const Arena arena{.name = "square", .half_side_m = 10.0, .extent_m = 20.0, .height_field = {}};
  const FoodWeb web{{"prey", "predator"}, {{1, 0}}};
  const View view{.time_s = 0.0, .tick = 0, .tick_s = 2.0, .web = web, .arena = arena, .robots = {}, .poses = {}};
  const observe::FrameTimes times{.steps = 120, .tick_s = 2.0, .clock_scale = 1.0};
  io::Recording recording{path, 5.0};
  observe::RunDescription run;
  run.fingerprint = "0123456789abcdef";
  run.seed = 4;
  recording.on_start(run, view);
  for (std::size_t frame = 0; frame < motion.roots.size(); ++frame) {
    recording.on_frame({.time_s = 0.2 * static_cast<double>(frame),
                        .times = times,
                        .roots = motion.roots[frame],
                        .joint_angles_rad = motion.angles_rad[frame],
                        .robot = robot_model(),
                        .arena = arena});
  }
  if (to_the_end) {
    recording.on_end(view);
  } else {
    recording.on_failure("it broke");
  }
}

inline void check_same(const io::RecordingReader& reader, const Motion& motion, std::size_t frames) {
  const io::recording::Units units;
  for (std::size_t frame = 0; frame < frames; ++frame) {
    for (std::size_t robot = 0; robot < robots; ++robot) {
      const Pose is = reader.root(frame, robot);
      const Pose was = motion.roots[frame][robot];
      REQUIRE((is.position_m - was.position_m).cwiseAbs().maxCoeff() <= 0.5001 * units.position_m);
      REQUIRE(is.orientation.angularDistance(was.orientation) < 0.005);
      for (std::size_t joint = 0; joint < joints; ++joint) {
        const double was_rad = motion.angles_rad[frame][robot * joints + joint];
        REQUIRE(std::abs(reader.joint_angle_rad(frame, robot, joint) - was_rad) <= 0.5001 * units.joint_rad);
      }
    }
  }
}

[[nodiscard]] inline std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file{path, std::ios::binary};
  return {std::istreambuf_iterator<char>{file}, {}};
}

[[nodiscard]] inline std::string refusal(const std::filesystem::path& path) {
  return message_of<std::runtime_error>([&] { static_cast<void>(io::RecordingReader{path}); });
}

}  // namespace trophic::test
