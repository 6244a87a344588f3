// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <iterator>
#include <support/temporary_folder.hpp>
#include <tools/recording/read_recording.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/io/run_folder.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/support/json.hpp>

#include "unit/observe/recorded_motion.hpp"

using namespace trophic;
using namespace trophic::test;
using io::Recording;
using io::RecordingReader;

TEST_CASE("recording: file exists, or invalid rate -> error") {
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

TEST_CASE("recording: many robots -> few frames buffered, correct positions") {
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "replay.trp";
  Experiment<rules::Paper> numbers;
  numbers.ecology.robots = 40000;
  numbers.ecology.arena = "walled_by_density";
  Ecology<rules::Paper> ecology{numbers, backend::Kinematic::Params{}};
  Recording recording{path, 5.0};
  ecology.run_until(8.0, recording);
  const std::string bytes = bytes_of(path);
  std::vector<std::uint32_t> frames_of_blocks;
  for (std::size_t at = io::recording::magic.size(); at < bytes.size();) {
    if (bytes.substr(at + 4, 4) == io::recording::frames_kind) {
      frames_of_blocks.push_back(io::recording::u32_at(bytes, at + 12));
    }
    at += 12 + io::recording::u32_at(bytes, at);
  }
  const std::uint32_t most = Recording::most_block_values / (40000 * 6);
  CHECK(frames_of_blocks == std::vector<std::uint32_t>{most, most, 41 - 2 * most});
  const RecordingReader reader{path};
  REQUIRE(reader.frames() == 41);
  const double far_m = ecology.view().arena.half_side_m;
  for (std::size_t body = 0; body < 40000; body += 997) {
    const Eigen::Vector3d at_m = reader.root(40, body).position_m;
    CHECK(at_m.x() == doctest::Approx(ecology.view().poses[body].x_m).epsilon(1e-3 * far_m));
    CHECK(at_m.y() == doctest::Approx(ecology.view().poses[body].y_m).epsilon(1e-3 * far_m));
  }
}

TEST_CASE("recording: checkpoint with an impossible recording -> error") {
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "replay.trp";
  Ecology<rules::Paper> ecology{Experiment<rules::Paper>{}, backend::Kinematic::Params{}};
  Recording recording{path, 5.0};
  struct Keep {
    void on_tick(const View&) {  // with frames that are not yet in a block
      Archive archive;
      recording.persist(archive);
      bytes = archive.bytes();
    }
    Recording& recording;
    std::string bytes = {};
  } kept{recording};
  ecology.run_until(10.0, recording, kept);
  const auto goes_on = [&](const std::string& bytes) {
    Recording again{path, 5.0, Opening::resumed};
    Archive archive{bytes};
    again.persist(archive);
  };
  CHECK_NOTHROW(goes_on(kept.bytes));
  constexpr std::size_t channels = 8 + 12 + 32;  // after rate, length and checksum of the file, and units
  for (const std::size_t at : {channels, channels + 8, channels + 16}) {
    for (const std::uint64_t number : {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{1} << 20U, std::uint64_t{1} << 62U}) {
      CAPTURE(at);
      CAPTURE(number);
      std::string bytes = kept.bytes;
      std::memcpy(bytes.data() + at, &number, sizeof(number));
      CHECK_THROWS_AS(goes_on(bytes), std::invalid_argument);
    }
  }
}

TEST_CASE("recording: with and without -> same tables, positions agree") {
  using Kinematics = Ecology<rules::Paper>;
  const test::TemporaryFolder folder;
  for (const double hz : {0.0, 5.0, 30.0}) {
    Kinematics ecology{{.seed = 5}, backend::Kinematic::Params{}};
    io::RunFolder files{folder.path() / number_text(hz), {}, {.replay_hz = hz}};
    ecology.run_until(120.0, files);
  }
  for (const char* file : {"events.csv", "agents.csv", "phylogeny.csv", "genomes.csv"}) {
    CAPTURE(file);
    const std::string none = bytes_of(folder.path() / "0" / file);
    CHECK(none.size() > 100);
    CHECK(none == bytes_of(folder.path() / "5" / file));
    CHECK(none == bytes_of(folder.path() / "30" / file));
  }
  const auto manifest_of = [&](const char* run) { return parse_json(bytes_of(folder.path() / run / "manifest.json")); };
  Json recorded = manifest_of("5");
  CHECK(recorded["recording"]["frames"] == Json(601));
  Json plain = manifest_of("0");
  for (const char* key : {"recording", "crc32"}) recorded.erase(key), plain.erase(key);
  CHECK(recorded == plain);
  CHECK_FALSE(std::filesystem::exists(folder.path() / "0" / "replay.trp"));
  const RecordingReader slow{folder.path() / "5" / "replay.trp"};
  const RecordingReader fast{folder.path() / "30" / "replay.trp"};
  CHECK(slow.frames() == 601);
  CHECK(fast.frames() == 3601);
  for (std::size_t frame = 0; frame < slow.frames(); frame += 50) {
    CHECK(slow.root(frame, 7).position_m == fast.root(6 * frame, 7).position_m);
  }
}
