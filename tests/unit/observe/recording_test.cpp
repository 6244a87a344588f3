// SPDX-License-Identifier: MIT
// replay.trp: what is written reads back, nothing else of a run changes, and what is damaged is said so.
#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <stdexcept>
#include <string>
#include <support/temporary_folder.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/load/habitat.hpp>
#include <trophic/observe/read_recording.hpp>
#include <trophic/observe/recording.hpp>
#include <trophic/observe/run_folder.hpp>
#include <trophic/population/food_web.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/support/rng.hpp>
#include <vector>

using namespace trophic;
using observe::FrameTimes;
using observe::Recording;
using observe::RecordingReader;

namespace {

constexpr std::size_t robots = 3;
constexpr std::size_t joints = 2;

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

[[nodiscard]] RobotModel two_joints() {
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

const RobotModel& robot_model() {
  static const RobotModel robot = two_joints();
  return robot;
}

void record(const std::filesystem::path& path, const Motion& motion, bool to_the_end = true) {
  const Arena arena{.name = "square", .half_side_m = 10.0, .extent_m = 20.0, .height_field = {}};
  const FoodWeb web{{"prey", "predator"}, {{1, 0}}};
  const View view{
      .time_s = 0.0, .tick = 0, .tick_s = 2.0, .web = web, .arena = arena, .robots = {}, .poses = {}, .grid = nullptr};
  const FrameTimes times{.steps = 120, .tick_s = 2.0, .clock_scale = 1.0};
  Recording recording{path, 5.0};
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

void check_same(const RecordingReader& reader, const Motion& motion, std::size_t frames) {
  const observe::recording::Units units;
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

[[nodiscard]] std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file{path, std::ios::binary};
  return {std::istreambuf_iterator<char>{file}, {}};
}

[[nodiscard]] std::string refusal(const std::filesystem::path& path) {
  return test::message_of<std::runtime_error>([&] { static_cast<void>(RecordingReader{path}); });
}

}  // namespace

TEST_CASE("every tick has the same frames, as evenly apart as its steps allow, the last at its end") {
  const FrameTimes times{.steps = 120, .tick_s = 2.0, .clock_scale = 1.0};
  CHECK(times.per_tick(5.0) == 10);
  CHECK(times.per_tick(0.0) == 0);
  CHECK(times.per_tick(0.01) == 1);
  CHECK(times.per_tick(1e6) == 120);
  CHECK(FrameTimes{.steps = 120, .tick_s = 2.0, .clock_scale = 0.5}.per_tick(5.0) == 5);
  for (const double hz : {0.1, 3.5, 5.0, 7.0, 30.0, 59.0, 60.0, 1000.0}) {
    CAPTURE(hz);
    const std::int64_t frames = times.per_tick(hz);
    std::int64_t step = 0;
    for (std::int64_t frame = 1; frame <= frames; ++frame) {
      const std::int64_t next = times.next(step, hz);
      REQUIRE(next == times.step_of(frame, frames));
      for (std::int64_t between = step + 1; between < next; ++between) REQUIRE_FALSE(times.due(between, hz));
      REQUIRE(times.due(next, hz));
      step = next;
    }
    CHECK(step == times.steps);
    CHECK(times.due(0, hz));
  }
  CHECK_FALSE(times.due(0, 0.0));
  CHECK(times.next(17, 0.0) == times.steps);
}

TEST_CASE("what is recorded reads back to its units, block by block and in any order") {
  const test::TemporaryFolder folder;
  const Motion motion{250};
  record(folder.path() / "replay.trp", motion);
  const RecordingReader reader{folder.path() / "replay.trp"};
  CHECK(reader.remark().empty());
  REQUIRE(reader.frames() == 250);
  check_same(reader, motion, 250);
  CHECK(reader.root(249, 2).position_m.isApprox(motion.roots[249][2].position_m, 0.01));
  CHECK(reader.root(0, 0).position_m.isApprox(motion.roots[0][0].position_m, 0.1));
  const auto& head = reader.head();
  CHECK(head.fingerprint == "0123456789abcdef");
  CHECK(head.seed == 4);
  CHECK(head.species == std::vector<std::string>{"prey", "predator"});
  CHECK(head.robots == robots);
  CHECK(head.joints == joints);
  CHECK(head.arena.half_side_m == 10.0);
  REQUIRE(head.robot.links.size() == joints + 1);
  CHECK(head.robot.links[2].parent == 1);
  CHECK(head.robot.links[2].offset_m == Eigen::Vector3d{0.1, 0.02, 0.003});
  CHECK(head.robot.links[1].boxes[0].half_extents_m == Eigen::Vector3d{0.1, 0.2, 0.3});
  CHECK(head.robot.hinges[1].axis == Eigen::Vector3d::UnitX());
  CHECK(reader.time_s(17) == doctest::Approx(3.4));
  CHECK(reader.frame_at(3.4) == 17);
  CHECK(reader.frame_at(3.5) == 17);
  CHECK(test::message_of<std::invalid_argument>([&] {
          static_cast<void>(reader.frame_at(51.0));
        }).find("time 51 s: must be between 0 and 49.8") == 0);
  CHECK_THROWS_AS(static_cast<void>(reader.root(250, 0)), std::out_of_range);
  CHECK_THROWS_AS(static_cast<void>(reader.root(0, robots)), std::out_of_range);
}

TEST_CASE("a run that failed keeps all its frames and has no end") {
  const test::TemporaryFolder folder;
  const Motion motion{130};
  record(folder.path() / "replay.trp", motion, false);
  const RecordingReader reader{folder.path() / "replay.trp"};
  REQUIRE(reader.frames() == 130);
  CHECK(reader.remark() == (folder.path() / "replay.trp").string() + ": ends early, after 130 frames (25.8 s)");
  check_same(reader, motion, 130);
}

TEST_CASE("a recording that was cut anywhere has the frames before the cut or is refused") {
  const test::TemporaryFolder folder;
  const Motion motion{210};
  record(folder.path() / "whole.trp", motion);
  const std::string whole = bytes_of(folder.path() / "whole.trp");
  std::size_t read = 0;
  for (std::size_t size = 0; size < whole.size(); size += 61) {
    CAPTURE(size);
    const std::filesystem::path path = folder.file("cut.trp", std::string_view{whole}.substr(0, size));
    if (const std::string sentence = refusal(path); !sentence.empty()) {
      CHECK(sentence.find(path.string() + ": ") == 0);
      CHECK(sentence.find('\n') == std::string::npos);
      continue;
    }
    const RecordingReader reader{path};
    CHECK(reader.remark().find("ends early, ") != std::string::npos);
    check_same(reader, motion, reader.frames());
    ++read;
  }
  CHECK(read > 10);
}

TEST_CASE("no flipped bit goes unnoticed") {
  const test::TemporaryFolder folder;
  const Motion motion{130};
  record(folder.path() / "whole.trp", motion);
  const std::string whole = bytes_of(folder.path() / "whole.trp");
  Rng rng{1, Stream::placement};
  for (int i = 0; i < 400; ++i) {
    const std::size_t at = i < 60 ? static_cast<std::size_t>(i) : rng.bits() % whole.size();
    std::string flipped = whole;
    flipped[at] = static_cast<char>(flipped[at] ^ (1 << (i % 8)));
    CAPTURE(at);
    const std::filesystem::path path = folder.file("flipped.trp", flipped);
    const std::string sentence = refusal(path);
    if (!sentence.empty()) continue;
    // Only a length that reaches beyond the file reads like a cut.
    const RecordingReader reader{path};
    REQUIRE_FALSE(reader.remark().empty());
    check_same(reader, motion, reader.frames());
  }
}

TEST_CASE("what is no recording is said to be none") {
  const test::TemporaryFolder folder;
  CHECK(refusal(folder.path() / "none.trp") == (folder.path() / "none.trp").string() + ": cannot be read");
  CHECK(refusal(folder.file("picture.trp", "\x89PNG\r\n\x1a\n and so on")).find(": is not a trophic recording") !=
        std::string::npos);
  CHECK(refusal(folder.file("empty.trp", "")).find(": is not a trophic recording") != std::string::npos);
  CHECK(refusal(folder.file("short.trp", observe::recording::magic)).find(": ends before its first frames") != std::string::npos);
}

TEST_CASE("a recording is new, and its rate is a number that makes sense") {
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder.file("replay.trp", "mine");
  CHECK(test::message_of<std::runtime_error>([&] { Recording(path, 5.0); }) ==
        "cannot create " + path.string() + ": File exists");
  CHECK(bytes_of(path) == "mine");
  for (const double hz : {-1.0, 2000.0, std::nan("")}) {
    CHECK_THROWS_AS(Recording(folder.path() / "other.trp", hz), std::invalid_argument);
  }
  Recording(folder.path() / "other.trp", 0.0);
  CHECK_FALSE(std::filesystem::exists(folder.path() / "other.trp"));
}

TEST_CASE("a recorded run has the bytes of one that is not, and the recording is where its tables say") {
  using Kinematics = Ecology<rules::Paper, backend::Kinematic>;
  const test::TemporaryFolder folder;
  for (const double hz : {0.0, 5.0, 30.0}) {
    Kinematics ecology{{.seed = 5}};
    observe::RunFolder files{folder.path() / number_text(hz), {}, hz};
    ecology.run_until(120.0, files);
  }
  for (const char* file : {"events.csv", "agents.csv", "phylogeny.csv", "genomes.csv", "manifest.json"}) {
    CAPTURE(file);
    const std::string none = bytes_of(folder.path() / "0" / file);
    CHECK(none.size() > 100);
    CHECK(none == bytes_of(folder.path() / "5" / file));
    CHECK(none == bytes_of(folder.path() / "30" / file));
  }
  CHECK_FALSE(std::filesystem::exists(folder.path() / "0" / "replay.trp"));
  const RecordingReader slow{folder.path() / "5" / "replay.trp"};
  const RecordingReader fast{folder.path() / "30" / "replay.trp"};
  CHECK(slow.frames() == 601);
  CHECK(fast.frames() == 3601);
  for (std::size_t frame = 0; frame < slow.frames(); frame += 50) {
    CHECK(slow.root(frame, 7).position_m == fast.root(6 * frame, 7).position_m);
  }
}
