// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <trophic/pictures/drawing/footage.hpp>
#include <trophic/pictures/watch/live_footage.hpp>
#include <unit/watch/footage.hpp>

using namespace trophic;

TEST_CASE("live footage: between two frames -> robots move straight, and beyond them -> they stand") {
  test::WrittenFootage written{{{.x_m = -3}, {.x_m = 2, .y_m = 1}}};
  for (int i = 0; i < 5; ++i) written.advance();
  CHECK(written.footage.newest_s() == 10.0);
  for (const double time_s : {0.0, 0.25, 0.5, 3.9, 9.99, 10.0}) {
    CAPTURE(time_s);
    for (std::size_t body = 0; body < 2; ++body) {
      CHECK(written.footage.root(time_s, body).position_m.x() == doctest::Approx(written.x_m(body, time_s)));
      const std::vector<double> angles_rad = written.footage.joint_angles_rad(time_s, body);
      REQUIRE(angles_rad.size() == 2);
      CHECK(angles_rad[0] == doctest::Approx(time_s));
      CHECK(angles_rad[1] == doctest::Approx(-time_s));
    }
  }
  CHECK(written.footage.root(99.0, 0).position_m.x() == doctest::Approx(written.x_m(0, 10.0)));
}

TEST_CASE("live footage: row of a tick -> holds until the next tick") {
  test::WrittenFootage written{{{.id = 5}}};
  written.population.individuals[0].id = 6;
  written.advance();
  CHECK(written.footage.rows_at(0.0)[0].id == 5);
  CHECK(written.footage.rows_at(1.99)[0].id == 5);
  CHECK(written.footage.rows_at(2.0)[0].id == 6);
  CHECK(written.footage.rows_at(99.0)[0].id == 6);
  CHECK(written.footage.ancestry(2.0, 0).age_s == 2.0);
}

TEST_CASE("live footage: frames before the shown moment -> dropped, and pictures stay the same") {
  test::WrittenFootage written{{{.x_m = -3}, {.x_m = 2}}};
  for (int i = 0; i < 100; ++i) {
    written.footage.add_death(written.population.view(), 0, false);
    written.advance();
  }
  const auto lines = [&] { return drawing::picture_of(written.footage, 190.3, {.marked = 1, .rows_s = {}, .named = {}}, "now"); };
  const drawing::Picture before = lines();
  const drawing::Picture fast = drawing::picture_of(written.footage, 190.3, {.flash_s = 40.0}, "now");
  CHECK(fast.flashes.size() == 20);
  written.footage.forget_before(190.3, 40.0);
  CHECK(drawing::picture_of(written.footage, 190.3, {.flash_s = 40.0}, "now").flashes.size() == 20);
  written.footage.forget_before(190.3);
  const drawing::Picture after = lines();
  CHECK(written.footage.frames() < 24);
  CHECK(written.footage.ticks() < 42);
  CHECK(before.lines.size() == 2 * 15);
  CHECK(before.lines.size() == after.lines.size());
  CHECK(before.lines.back().x1_m == after.lines.back().x1_m);
  CHECK(before.flashes.size() == 3);
  CHECK(after.flashes.size() == 3);
  CHECK(drawing::picture_of(written.footage, 190.3, {.flash_s = 40.0}, "now").flashes.size() == 3);  // the others are dropped
  CHECK(after.robots[1].is_marked);
  CHECK_FALSE(after.robots[0].is_marked);
  CHECK(after.robots[0].filled);
}

TEST_CASE("live footage: run resumed from a checkpoint -> frames only after its first tick") {
  watch::LiveFootage footage;
  test::HandPopulation robots{{{}}};
  footage.start({}, robots.at_tick(50).view());
  CHECK_FALSE(footage.is_ready());
  const Pose pose{.position_m = {1, 2, 0.1}, .orientation = Eigen::Quaterniond::Identity()};
  const RobotModel model;
  footage.add_frame(
      {.time_s = 100.1, .times = {}, .roots = {&pose, 1}, .joint_angles_rad = {}, .robot = model, .arena = robots.arena});
  REQUIRE(footage.is_ready());
  CHECK(footage.newest_s() == 100.0);
  CHECK(footage.root(100.0, 0).position_m.x() == 1.0);
  CHECK(drawing::picture_of(footage, 100.0, {}, "").robots.size() == 1);
}
