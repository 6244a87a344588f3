// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <numbers>
#include <stdexcept>
#include <support/statistics.hpp>
#include <trophic/initialization/placement/uniform_square.hpp>
#include <vector>

using namespace trophic;
using initialization::placement::UniformSquare;

namespace {

Arena square_of(double half_side_m) {
  Arena square;
  square.half_side_m = half_side_m;
  return square;
}

}  // namespace

TEST_CASE("uniform square: default -> positions uniform within +-9 m, equal headings") {
  Rng rng{2, Stream::placement};
  const std::vector<GroundPose> poses = UniformSquare{}.place(100'000, square_of(9.333), 0.2, rng);
  std::vector<double> x_m;
  std::vector<double> y_m;
  for (const GroundPose& pose : poses) {
    x_m.push_back(pose.x_m);
    y_m.push_back(pose.y_m);
    REQUIRE(pose.heading_rad == -0.75 * std::numbers::pi);
  }
  REQUIRE(x_m.size() == 100'000);
  CHECK(test::chi_square(test::histogram(x_m, -9.0, 9.0, 20)) < 50.0);  // 19 degrees of freedom: p = 1e-4
  CHECK(test::chi_square(test::histogram(y_m, -9.0, 9.0, 20)) < 50.0);
}

TEST_CASE("uniform square: another square and heading -> as set, up to the arena's edge") {
  Rng rng{3, Stream::placement};
  const UniformSquare rule{{.half_extent_m = 2.0, .heading_rad = 1.0}};
  for (const GroundPose& pose : rule.place(1000, square_of(2.0), 0.2, rng)) {
    CHECK(pose.x_m >= -2.0);
    CHECK(pose.x_m < 2.0);
    CHECK(pose.heading_rad == 1.0);
  }
}

TEST_CASE("uniform square: square larger than the arena -> error with both numbers") {
  Rng rng{4, Stream::placement};
  CHECK_THROWS_WITH_AS(static_cast<void>(UniformSquare{}.place(1, square_of(8.5), 0.2, rng)),
                       "rules.placement.half_extent_m = 9: must be <= 8.5, the arena's half side", std::invalid_argument);
}

TEST_CASE("uniform square: more robots -> same positions of the first ones, two draws each") {
  Rng few{5, Stream::placement};
  Rng many{5, Stream::placement};
  const auto first = UniformSquare{}.place(3, Arena{}, 0.2, few);
  const auto all = UniformSquare{}.place(9, Arena{}, 0.2, many);
  for (std::size_t i = 0; i < 3; ++i) CHECK(first[i].x_m == all[i].x_m);
}
