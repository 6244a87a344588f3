// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>
#include <sys/stat.h>

#include <iterator>
#include <support/forged_recording.hpp>
#include <support/temporary_folder.hpp>
#include <tools/recording/read_recording.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/io/run_folder.hpp>
#include <trophic/rules/paper.hpp>

#include "unit/observe/recorded_motion.hpp"

using namespace trophic;
using namespace trophic::test;
using io::RecordingReader;

TEST_CASE("read recording: recorded frames -> read back to their units, in any order of blocks") {
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

TEST_CASE("read recording: failed run -> all frames, no end") {
  const test::TemporaryFolder folder;
  const Motion motion{130};
  record(folder.path() / "replay.trp", motion, false);
  const RecordingReader reader{folder.path() / "replay.trp"};
  REQUIRE(reader.frames() == 130);
  CHECK(reader.remark() == (folder.path() / "replay.trp").string() + ": ends early, after 130 frames (25.8 s)");
  check_same(reader, motion, 130);
}

TEST_CASE("read recording: file cut anywhere -> frames up to the cut, or an error") {
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

TEST_CASE("read recording: any flipped bit -> error") {
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

TEST_CASE("read recording: a pipe or a folder in its place -> error at once") {
  const test::TemporaryFolder folder;
  const std::filesystem::path pipe = folder.path() / "replay.trp";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  for (const std::filesystem::path& path : {pipe, folder.path()}) {
    CHECK(message_of<std::runtime_error>([&] { RecordingReader{path}; }).ends_with(": is not a regular file"));
  }
}

TEST_CASE("read recording: another file -> error") {
  const test::TemporaryFolder folder;
  CHECK(refusal(folder.path() / "none.trp") ==
        (folder.path() / "none.trp").string() + ": cannot be read: No such file or directory");
  CHECK(refusal(folder.file("picture.trp", "\x89PNG\r\n\x1a\n and so on")).find(": is not a trophic recording") !=
        std::string::npos);
  CHECK(refusal(folder.file("empty.trp", "")).find(": is not a trophic recording") != std::string::npos);
  CHECK(refusal(folder.file("short.trp", io::recording::magic)).find(": ends before its first frames") != std::string::npos);
}

TEST_CASE("read recording: invalid numbers in the head -> error before allocation") {
  const test::TemporaryFolder folder;
  record(folder.path() / "replay.trp", Motion{130});
  const std::string whole = bytes_of(folder.path() / "replay.trp");
  const std::size_t size = io::recording::u32_at(whole, 8);
  const std::string head = whole.substr(16, size);
  const auto refused = [&](const std::string& what, const std::string& by) {
    const std::size_t at = head.find(what);
    REQUIRE(at != std::string::npos);
    std::string changed = head;
    changed.replace(at, what.size(), by);
    const std::filesystem::path path = folder.file("forged.trp", recording_with(changed, whole.substr(20 + size)));
    const std::string sentence = refusal(path);
    return sentence.empty() ? "" : sentence.substr(path.string().size());
  };
  CHECK(refused("\"robots\":3", "\"robots\":3").empty());
  const std::string cannot = ": cannot read its header: ";
  CHECK(refused("\"robots\":3", "\"robots\":-3") == cannot + "robots = -3: must be a whole number from 1 to 4294967295");
  CHECK(refused("\"robots\":3", "\"robots\":1e300") == cannot + "robots = 1e+300: must be a whole number from 1 to 4294967295");
  CHECK(refused("\"robots\":3", "\"robots\":4294967296") ==
        cannot + "robots = 4294967296: must be a whole number from 1 to 4294967295");
  CHECK(refused("\"robots\":3", "\"robots\":4294967295")
            .find(": damaged, more frames than its bytes can hold in the block at byte ") == 0);
  CHECK(refused("\"joints\":2", "\"joints\":1") == cannot + "joints = 1: must be 0 or 2, the number of its robot's hinges");
  CHECK(refused("\"frames_per_tick\":", "\"frames_per_tick\":1234567890123").find("frames_per_tick = ") != std::string::npos);
  CHECK(refused("\"steps_per_tick\":", "\"steps_per_tick\":1234567890123").find("steps_per_tick = ") != std::string::npos);
  CHECK(refused("\"seed\":4", "\"seed\":4.5") == cannot + "seed = 4.5: must be a whole number from 0 to 18446744073709551615");
  CHECK(refused("\"half_side_m\":",
                "\"height_field\":{\"nodes\":4294967296,\"half_extent_m\":1,\"height_m\":[]},\"half_side_m\":") ==
        cannot + "nodes = 4294967296: must be a whole number from 2 to 4294967295");
}

TEST_CASE("read recording: block with too many frames for its bytes -> error") {
  const test::TemporaryFolder folder;
  record(folder.path() / "replay.trp", Motion{50}, false);
  const std::string whole = bytes_of(folder.path() / "replay.trp");
  const std::size_t size = io::recording::u32_at(whole, 8);
  std::string blocks = whole.substr(20 + size);
  REQUIRE(io::recording::u32_at(blocks, 12) == 50);
  blocks.replace(12, 4, "\xff\xff\xff\xff");
  const std::filesystem::path path = folder.file("forged.trp", recording_with(whole.substr(16, size), blocks));
  CHECK(refusal(path).find(": damaged, more frames than its bytes can hold in the block at byte ") != std::string::npos);
}

TEST_CASE("read recording: moments closer than the resolution -> found") {
  const test::TemporaryFolder folder;
  record(folder.path() / "replay.trp", Motion{50});
  const std::string whole = bytes_of(folder.path() / "replay.trp");
  const std::size_t size = io::recording::u32_at(whole, 8);
  std::string head = whole.substr(16, size);
  const std::size_t at = head.find("\"tick_s\":");
  head.replace(at, head.find(',', at) - at, "\"tick_s\":5e-324");
  const RecordingReader reader{folder.file("forged.trp", recording_with(head, whole.substr(20 + size)))};
  CHECK(reader.frame_at(reader.time_s(0)) < reader.frames());
}
