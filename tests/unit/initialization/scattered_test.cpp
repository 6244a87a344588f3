// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <stdexcept>
#include <support/statistics.hpp>
#include <trophic/initialization/placement/scattered.hpp>
#include <vector>

using namespace trophic;
using initialization::placement::Scattered;

namespace {

Arena arena(double half_side_m) {
  Arena square;
  square.half_side_m = half_side_m;
  return square;
}

}  // namespace

TEST_CASE("scattered: positions -> one radius from the walls, two from each other") {
  CHECK(rc::check([](std::uint64_t seed) {
    Rng rng{seed, Stream::placement};
    const double radius_m = 0.2 + 0.001 * static_cast<double>(seed % 300);
    const std::vector<GroundPose> poses = Scattered{}.place(30, Arena{}, radius_m, rng);
    RC_ASSERT(poses.size() == 30U);
    for (std::size_t i = 0; i < poses.size(); ++i) {
      RC_ASSERT(std::abs(poses[i].x_m) <= 10.0 - radius_m);
      RC_ASSERT(std::abs(poses[i].y_m) <= 10.0 - radius_m);
      RC_ASSERT(std::abs(poses[i].heading_rad) <= std::numbers::pi);
      for (std::size_t j = 0; j < i; ++j) RC_ASSERT(distance_m(poses[i], poses[j]) >= 2.0 * radius_m);
    }
  }));
}

TEST_CASE("scattered: many placements -> uniform positions and headings") {
  std::vector<double> x_m;
  std::vector<double> y_m;
  std::vector<double> heading_rad;
  for (std::uint64_t seed = 0; seed < 100'000; ++seed) {
    Rng rng{seed, Stream::placement};
    const GroundPose pose = Scattered{}.place(1, Arena{}, 0.5, rng).at(0);
    x_m.push_back(pose.x_m);
    y_m.push_back(pose.y_m);
    heading_rad.push_back(pose.heading_rad);
  }
  // 19 degrees of freedom: p = 1e-4
  CHECK(test::chi_square(test::histogram(x_m, -9.5, 9.5, 20)) < 50.0);
  CHECK(test::chi_square(test::histogram(y_m, -9.5, 9.5, 20)) < 50.0);
  CHECK(test::chi_square(test::histogram(heading_rad, -std::numbers::pi, std::numbers::pi, 20)) < 50.0);
  double products = 0.0;
  for (std::size_t i = 0; i < x_m.size(); ++i) products += x_m[i] * y_m[i] / 100'000.0;
  CHECK(std::abs(products) < 4.0 * (19.0 * 19.0 / 12.0) / std::sqrt(100'000.0));
}

TEST_CASE("scattered: too many robots or one too large -> error, no endless loop") {
  Rng rng{1, Stream::placement};
  CHECK_THROWS_AS(static_cast<void>(Scattered{}.place(10, arena(1.0), 0.5, rng)), std::invalid_argument);
  CHECK_THROWS_WITH_AS(static_cast<void>(Scattered{}.place(1, arena(1.0), 1.5, rng)),
                       "robot bounding radius = 1.5 m: must be <= 1, the arena's half side", std::invalid_argument);
  CHECK(Scattered{}.place(0, Arena{}, 0.2, rng).empty());
}

TEST_CASE("scattered: a thousand robots -> positions of an exhaustive search") {
  for (const double radius_m : {0.05, 0.1, 0.2}) {
    CAPTURE(radius_m);
    Rng rng{7, Stream::placement};
    const std::vector<GroundPose> poses = Scattered{}.place(1000, Arena{}, radius_m, rng);
    Rng again{7, Stream::placement};
    const double reach_m = 10.0 - radius_m;
    std::vector<GroundPose> expected;
    while (expected.size() < 1000) {
      GroundPose pose;
      pose.x_m = again.uniform(-reach_m, reach_m);
      pose.y_m = again.uniform(-reach_m, reach_m);
      pose.heading_rad = again.uniform(-std::numbers::pi, std::numbers::pi);
      const auto is_apart = [&](const GroundPose& other) { return distance_m(other, pose) >= 2.0 * radius_m; };
      if (std::ranges::all_of(expected, is_apart)) expected.push_back(pose);
    }
    for (std::size_t i = 0; i < 1000; ++i) {
      CHECK(poses[i].x_m == expected[i].x_m);
      CHECK(poses[i].y_m == expected[i].y_m);
      CHECK(poses[i].heading_rad == expected[i].heading_rad);
    }
  }
}

TEST_CASE("scattered: robot as large as the arena -> in its centre, larger -> error") {
  Rng rng{1, Stream::placement};
  const auto place = [&](double radius_m) { return Scattered{}.place(1, arena(0.5), radius_m, rng); };
  const GroundPose only = place(0.5).at(0);
  CHECK(only.x_m == 0.0);
  CHECK(only.y_m == 0.0);
  CHECK_THROWS_AS(place(0.500001), std::invalid_argument);
}
