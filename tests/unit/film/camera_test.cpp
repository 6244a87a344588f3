// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <tools/film/camera.hpp>

using namespace trophic;

TEST_CASE("camera: from above -> its point in the middle, north at the top, east on the right") {
  const film::Camera camera{.at_m = {3, 4, 0}, .distance_m = 9, .azimuth_deg = 30, .elevation_deg = -40};
  CHECK(film::seen_at(camera, camera.at_m)->x == doctest::Approx(0.0));
  CHECK(film::seen_at(camera, camera.at_m)->y == doctest::Approx(0.0));
  const film::Camera above = film::from_above({}, 1.5);
  CHECK(film::seen_at(above, {1, 0, 0})->x > 0.0);
  CHECK(film::seen_at(above, {0, 1, 0})->y > 0.0);
  CHECK_FALSE(film::seen_at(above, {0, 0, 2.0 * above.distance_m}).has_value());
}

TEST_CASE("camera: wide or high picture -> the whole arena is in it") {
  for (const double aspect : {0.5, 1.0, 16.0 / 9.0, 3.0}) {
    Arena arena;
    arena.half_side_m = 12.0;
    for (const film::Camera& camera : {film::whole_arena(arena, aspect), film::from_above(arena, aspect)}) {
      for (const double x : {-12.0, 12.0}) {
        for (const double y : {-12.0, 12.0}) {
          const auto corner = film::seen_at(camera, {x, y, 0.0});
          CAPTURE(aspect);
          CHECK(std::abs(corner->x) < aspect);
          CHECK(std::abs(corner->y) < 1.0);
        }
      }
    }
  }
}
