// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <trophic/pictures/drawing/camera.hpp>
#include <trophic/pictures/watch/eye.hpp>
#include <trophic/support/rng.hpp>

using namespace trophic;

TEST_CASE("camera: floor point at a place of the picture -> is seen at that place") {
  Rng rng{7, Stream::user};
  int seen = 0;
  for (int i = 0; i < 500; ++i) {
    const drawing::Camera camera{.at_m = {rng.uniform(-5, 5), rng.uniform(-5, 5), 0.0},
                                 .distance_m = rng.uniform(1, 40),
                                 .azimuth_deg = rng.uniform(-180, 180),
                                 .elevation_deg = rng.uniform(-90, -10)};
    const drawing::PicturePoint point{rng.uniform(-1.5, 1.5), rng.uniform(-1, 1)};
    const auto on_floor = drawing::floor_at(camera, point);
    if (!on_floor) continue;
    ++seen;
    const auto back = drawing::seen_at(camera, {on_floor->x(), on_floor->y(), 0.0});
    REQUIRE(back.has_value());
    CHECK(back->x == doctest::Approx(point.x).epsilon(1e-6));
    CHECK(back->y == doctest::Approx(point.y).epsilon(1e-6));
  }
  CHECK(seen > 400);
}

TEST_CASE("camera: from above -> its point in the middle, north at the top, east on the right") {
  const drawing::Camera camera{.at_m = {3, 4, 0}, .distance_m = 9, .azimuth_deg = 30, .elevation_deg = -40};
  CHECK(drawing::seen_at(camera, camera.at_m)->x == doctest::Approx(0.0));
  CHECK(drawing::seen_at(camera, camera.at_m)->y == doctest::Approx(0.0));
  const drawing::Camera above = drawing::from_above({}, 1.5);
  CHECK(drawing::seen_at(above, {1, 0, 0})->x > 0.0);
  CHECK(drawing::seen_at(above, {0, 1, 0})->y > 0.0);
  CHECK_FALSE(drawing::seen_at(above, {0, 0, 2.0 * above.distance_m}).has_value());
  CHECK_FALSE(drawing::floor_at({.elevation_deg = -5}, {0.0, 1.0}).has_value());
}

TEST_CASE("camera: wide or high picture -> the whole arena is in it") {
  for (const double aspect : {0.5, 1.0, 16.0 / 9.0, 3.0}) {
    Arena arena;
    arena.half_side_m = 12.0;
    for (const drawing::Camera& camera : {drawing::whole_arena(arena, aspect), drawing::from_above(arena, aspect)}) {
      for (const double x : {-12.0, 12.0}) {
        for (const double y : {-12.0, 12.0}) {
          const auto corner = drawing::seen_at(camera, {x, y, 0.0});
          CAPTURE(aspect);
          CHECK(std::abs(corner->x) < aspect);
          CHECK(std::abs(corner->y) < 1.0);
        }
      }
    }
  }
}

TEST_CASE("eye: shift -> the floor moves with the mouse") {
  watch::Eye eye;
  eye.see_from_above({}, 1.5);
  const auto before = drawing::floor_at(eye.camera(), {0.2, 0.1});
  eye.shift(0.05, -0.1);  // parts of the height; a picture is 2 high
  const auto after = drawing::floor_at(eye.camera(), {0.2 + 0.1, 0.1 - 0.2});
  CHECK((*before - *after).norm() < 1e-9);
}

TEST_CASE("eye: turned or moved to its limits -> neither below the floor nor through its target") {
  watch::Eye eye;
  for (int i = 0; i < 100; ++i) eye.turn(0.3, 0.5);
  CHECK(eye.camera().elevation_deg == -5.0);
  for (int i = 0; i < 100; ++i) eye.turn(0.3, -0.5);
  CHECK(eye.camera().elevation_deg == -90.0);
  CHECK(std::abs(eye.camera().azimuth_deg) <= 180.0);
  for (int i = 0; i < 100; ++i) eye.zoom(1.0);
  CHECK(eye.camera().distance_m == 0.2);
}
