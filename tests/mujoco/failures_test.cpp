// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <mujoco/touching.hpp>
#include <string>
#include <support/memory.hpp>
#include <trophic/backend/mujoco/compiled_model.hpp>

using namespace trophic;
using backend::Mujoco;
using test::spider;
using test::square;

namespace {

std::vector<Mujoco::Params> all_modes() {
  return {{.stepping = Mujoco::Stepping::fast, .threads = 2},
          {.stepping = Mujoco::Stepping::islands, .threads = 2},
          {.stepping = Mujoco::Stepping::one_model}};
}

template <class Make>
std::string complaint(Make&& make) {
  try {
    make();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

bool contains(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("failures: timestep too large -> Diverged with time and robot, last sound state kept") {
  const std::vector<Pose> starts = test::lattice(spider, 6, 2.0);
  for (const Mujoco::Params& params : all_modes()) {
    Mujoco backend{spider, square, starts, {.timestep_s = 0.02}, params};
    double diverged_s = -1.0;
    try {
      test::walk(backend, 60.0);
    } catch (const Diverged& diverged) {
      MESSAGE(std::string{diverged.what()});
      diverged_s = diverged.time_s();
      CHECK(diverged.robot() < 6);
      CHECK(contains(diverged.what(), "robot " + std::to_string(diverged.robot())));
    }
    CHECK(diverged_s >= backend.time_s());
    CHECK(diverged_s <= backend.time_s() + 0.1);
    for (std::size_t i = 0; i < 6; ++i) CHECK(backend.pose(i).position_m.allFinite());
  }
}

TEST_CASE("failures: unphysically fast robots -> Diverged before all become one group") {
  const std::vector<Pose> starts = test::lattice(spider, 200, 2.0);
  const double before = test::resident_bytes();
  for (const auto stepping : {Mujoco::Stepping::fast, Mujoco::Stepping::islands}) {
    Arena wide = square;
    wide.half_side_m = 30.0;
    wide.extent_m = 60.0;
    Mujoco backend{spider, wide, starts, {.timestep_s = 0.008333}, {.stepping = stepping, .threads = 2}};
    std::string said = "nothing";
    try {
      test::walk(backend, 1.0);
    } catch (const Diverged& diverged) {
      said = diverged.what();
    }
    CHECK_MESSAGE(contains(said, "it is faster than 100 m/s; physics.timestep_s may be too long"), said);
  }
  CHECK(test::resident_bytes() - before < 1e9);
}

TEST_CASE("failures: number that is not finite, also over a height field -> Diverged with its robot") {
  std::vector<Pose> high = test::lattice(spider, 4, 2.0);
  for (Pose& start : high) start.position_m.z() += 1.0;
  for (const auto& [arena, starts] : {std::pair{square, test::lattice(spider, 4, 0.45)}, {load_arena("height_field"), high}}) {
    for (const Mujoco::Params& params : all_modes()) {
      Mujoco backend{spider, arena, starts, {}, params};
      backend.advance_to(0.1);
      const Mujoco::State sound = backend.save();
      for (const std::size_t column : {0U, 2U, 4U, 8U, 7U + 4U + 3U}) {
        CAPTURE(column);
        Mujoco::State broken = sound;
        broken.robots[sound.robots.size() / 2 + column] = std::numeric_limits<double>::quiet_NaN();
        backend.restore(broken);
        try {
          backend.advance_to(0.2);
          FAIL("went on with NaN");
        } catch (const Diverged& diverged) {
          CHECK(diverged.robot() == 2);
          CHECK(diverged.time_s() == doctest::Approx(backend.time_s()).epsilon(0.02));
        }
      }
      backend.restore(sound);
      CHECK_NOTHROW(backend.advance_to(0.2));
    }
  }
}

TEST_CASE("failures: robots start inside one another -> pushed apart, run continues") {
  std::vector<Pose> starts = test::lattice(spider, 4, 3.0);
  starts.push_back(starts[0]);                                 // exactly the same place
  starts.push_back(test::standing(spider, 3.02, 3.01, 0.3));   // nearly
  starts.push_back(test::standing(spider, 9.99, -9.99, 0.3));  // half in two walls
  Mujoco backend{spider, square, starts, {}, {.threads = 2}};
  CHECK_NOTHROW(test::walk(backend, 5.0));
  for (std::size_t i = 0; i < starts.size(); ++i) {
    CAPTURE(i);
    const Eigen::Vector3d at = backend.pose(i).position_m;
    CHECK(at.allFinite());
    CHECK(std::max(std::abs(at.x()), std::abs(at.y())) < 10.0);
  }
}

TEST_CASE("failures: heap of robots -> capacity for all contacts") {
  const std::vector<Pose> starts = test::crowd(spider, 4, 0.1, 3);
  test::TouchWatch watch{spider, square, 4};
  const std::size_t first_room = watch.room();
  CHECK(first_room < 1500);
  Mujoco backend{spider, square, starts, {}, {.threads = 1}};
  watch.look(backend);
  CHECK(watch.most_rows() > static_cast<int>(first_room));
  CHECK_NOTHROW(test::walk(backend, 1.0));
}

// MuJoCo 3 counts its memory in 64 bits and stores them.
TEST_CASE("failures: more contacts than MuJoCo can store -> error, none lost" * doctest::skip(backend::mujoco::is_mujoco_3)) {
  Mujoco backend{spider, square, test::crowd(spider, 12, 0.1, 3), {}, {.stepping = Mujoco::Stepping::islands}};
  CHECK_THROWS_AS(backend.advance_to(0.1), Diverged);
  CHECK(backend.time_s() == 0.0);
}

TEST_CASE("failures: moving crowd -> no contact dropped") {
  const std::vector<Pose> starts = test::tight_crowd(spider, 24, 3.0, 5000);
  backend::mujoco::CompiledModel single{spider, square, {}, {}, 1, 1};
  Mujoco backend{spider, square, starts, {}, {.threads = 2}};
  test::TouchWatch watch{spider, square, starts.size()};
  for (double time_s = 0.1; time_s < 2.05; time_s += 0.1) {
    test::walk(backend, time_s);  // a dropped row would be a warning, and a warning throws
    watch.look(backend);
  }
  CHECK(watch.most_rows() > 24 * 8);
  CHECK(single.model().njmax >= 17 * 4 * 4);  // every box on its four lower corners, four rows each
}

TEST_CASE("failures: bad input -> named error before the simulation") {
  const std::vector<Pose> starts = test::lattice(spider, 2, 1.0);
  const auto with_threads = [&](std::size_t threads) {
    return complaint([&] { Mujoco{spider, square, starts, {}, {.threads = threads}}; });
  };
  CHECK(contains(with_threads(0), "mujoco.threads = 0: must be >= 1"));
  CHECK(contains(with_threads(5000), "mujoco.threads = 5000"));
  CHECK(contains(complaint([&] { Mujoco{spider, square, {}, {}, {}}; }), "robots = 0"));
  CHECK(contains(complaint([&] { Mujoco{spider, square, starts, {.timestep_s = -1.0}, {}}; }), "physics.timestep_s = -1"));
  const auto from = [&](const Eigen::Vector3d& at) {
    std::vector<Pose> outside = starts;
    outside[1].position_m = at;
    return complaint([&] { Mujoco{spider, square, outside, {}, {}}; });
  };
  CHECK(contains(from({10.5, 0.0, 0.1}), "start pose 1 at (10.5, 0, 0.1): must be finite and within +-10"));
  CHECK(contains(from({0.0, std::nan(""), 0.1}), "): must be finite and within +-10"));
  CHECK(contains(from({0.0, 0.0, std::numeric_limits<double>::infinity()}), "inf): its height must be finite and within +-"));
  std::vector<Pose> unturned = starts;
  unturned[0].orientation.coeffs().setZero();
  CHECK(contains(complaint([&] {
                   Mujoco{spider, square, unturned, {}, {}};
                 }),
                 "start pose 0 has an orientation of norm 0: must be > 0.5 and < 2"));
  RobotModel weightless = spider;
  weightless.links[1].mass_kg = 0.0;
  CHECK(complaint([&] { Mujoco{weightless, square, starts, {}, {}}; }) != "accepted");

  Mujoco backend{spider, square, starts, {}, {}};
  const std::vector<double> three(3, 0.0);
  const std::vector<double> wrong{0.0, 0.0, std::nan(""), 0.0};
  CHECK(contains(complaint([&] { backend.set_joint_targets(1, three); }), "joint targets of robot 1: 3 numbers: must be 4"));
  CHECK(contains(complaint([&] { backend.set_joint_targets(1, wrong); }), "joint target 2 of robot 1"));
}
