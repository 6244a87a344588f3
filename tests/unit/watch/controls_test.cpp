// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cstddef>
#include <string>
#include <trophic/pictures/watch/controls.hpp>
#include <trophic/pictures/watch/inspector.hpp>
#include <unit/watch/footage.hpp>

using namespace trophic;

namespace {

/// Three robots two ticks into a run that has just been paused.
struct Scene {
  test::WrittenFootage written{{{.species = test::predator, .x_m = -4, .y_m = 3, .tag = -1, .id = 17},
                                {.x_m = 5, .y_m = -2, .id = 18},
                                {.x_m = 0, .y_m = 0, .active = false, .id = 19}}};
  watch::LiveFootage& footage = written.footage;
  watch::WindowSize window{1280, 720};
  watch::Controls controls;

  Scene() {
    written.advance();
    written.advance();
    look();
    press(watch::Key::pause);
  }
  void look(double elapsed_s = 0.0) { controls.advance(footage, elapsed_s, window); }
  void press(watch::Key key) { controls.press(key, footage, window); }
  /// A pixel near the foot of a robot.
  [[nodiscard]] std::pair<double, double> pixel(std::size_t body) const {
    Eigen::Vector3d at = footage.root(controls.clock().time_s(), body).position_m;
    at.z() = 0.0;
    const auto point = drawing::seen_at(controls.camera(), at);
    return {0.5 * (window.width + point->x * window.height), 0.5 * (window.height - point->y * window.height)};
  }
  void click(double x, double y) {
    controls.press_mouse(watch::Button::turns, x, y);
    controls.move_mouse(x + 1, y, window);
    controls.release_mouse(footage, window);
  }
};

}  // namespace

TEST_CASE("controls: click on a robot -> selects it, and click elsewhere -> deselects") {
  Scene scene;
  for (const auto key : {watch::Key::whole, watch::Key::top}) {
    scene.press(key);
    for (std::size_t body = 0; body < 3; ++body) {
      const std::pair<double, double> at = scene.pixel(body);
      scene.click(at.first, at.second);
      CHECK(scene.controls.selected() == 17 + body);
      CHECK(scene.controls.selected_body(scene.footage) == body);
    }
    scene.click(30, 700);
    CHECK_FALSE(scene.controls.selected().has_value());
  }
}

TEST_CASE("controls: drag -> turns or moves the view and selects no robot") {
  Scene scene;
  const drawing::Camera before = scene.controls.camera();
  scene.controls.press_mouse(watch::Button::turns, 600, 300);
  scene.controls.move_mouse(700, 300, scene.window);
  scene.controls.release_mouse(scene.footage, scene.window);
  CHECK(scene.controls.camera().azimuth_deg < before.azimuth_deg);
  CHECK_FALSE(scene.controls.selected().has_value());
  scene.controls.move_mouse(900, 300, scene.window);  // no button is held
  const drawing::Camera turned = scene.controls.camera();
  scene.controls.press_mouse(watch::Button::shifts, 600, 300);
  scene.controls.move_mouse(600, 400, scene.window);
  scene.controls.release_mouse(scene.footage, scene.window);
  CHECK(scene.controls.camera().azimuth_deg == turned.azimuth_deg);
  CHECK((scene.controls.camera().at_m - turned.at_m).norm() > 0.1);
  scene.controls.turn_wheel(2.0);
  CHECK(scene.controls.camera().distance_m < turned.distance_m);
}

TEST_CASE("controls: followed robot -> stays in the middle until it is deselected") {
  Scene scene;
  scene.press(watch::Key::follow);
  CHECK_FALSE(scene.controls.is_following());  // no robot was selected
  scene.press(watch::Key::next);
  scene.press(watch::Key::follow);
  for (int i = 0; i < 3; ++i) {
    scene.written.advance();
    scene.press(watch::Key::step);
    scene.look();
    const Eigen::Vector3d at = scene.footage.root(scene.controls.clock().time_s(), 0).position_m;
    CHECK((scene.controls.camera().at_m.head<2>() - at.head<2>()).norm() < 1e-12);
  }
  scene.press(watch::Key::follow);
  CHECK_FALSE(scene.controls.is_following());
  CHECK(scene.controls.selected() == 17);
  scene.press(watch::Key::deselect);
  CHECK_FALSE(scene.controls.selected().has_value());
}

TEST_CASE("controls: next -> cycles through the robots, and selected robot dies -> stays selected as dead") {
  Scene scene;
  for (const IndividualId id : {17U, 18U, 19U, 17U}) {
    scene.press(watch::Key::next);
    CHECK(scene.controls.selected() == id);
  }
  scene.press(watch::Key::follow);
  scene.written.population.individuals[0].id = 20;
  scene.written.advance();
  CHECK(watch::moment_text(scene.controls, scene.footage, false) == "0.0 s, paused, robot 17");
  for (int i = 0; i < 3; ++i) {
    scene.press(watch::Key::step);
    scene.look();
  }
  CHECK(scene.controls.selected() == 17);
  CHECK_FALSE(scene.controls.selected_body(scene.footage).has_value());
  CHECK(watch::moment_text(scene.controls, scene.footage, true) == "6.0 s, paused, the run has ended, robot 17 (dead)");
  CHECK(watch::inspected(scene.controls, scene.footage).right == "17\ndead");
}

TEST_CASE("inspector: selected robot -> its data as text") {
  Scene scene;
  CHECK(watch::inspected(scene.controls, scene.footage).left.empty());
  scene.written.population.individuals[0].parent = 3;
  scene.written.population.individuals[0].adversary = 1;
  scene.written.population.individuals[0].adversary_distance_m = 2.5;
  scene.written.advance();
  for (int i = 0; i < 3; ++i) {
    scene.press(watch::Key::step);
    scene.look();
  }
  scene.press(watch::Key::next);
  const watch::Columns about = watch::inspected(scene.controls, scene.footage);
  CHECK(about.left == "robot\nspecies\ntag\nage\nhunger\norigin\nparent\nsees\nat\nturns by\nbody");
  CHECK(about.right == "17\npredator\n-1\n6.0 s\n3 ticks\nrandom\n3\n18\n2.5 m\n0.0 deg\n0");
  scene.press(watch::Key::next);
  scene.press(watch::Key::next);
  CHECK(watch::inspected(scene.controls, scene.footage).right.find("not active yet") != std::string::npos);
}

TEST_CASE("controls: help -> a meaning for each key") {
  const auto lines = [](std::string_view text) { return std::ranges::count(text, '\n'); };
  CHECK(lines(watch::Controls::help) == lines(watch::Controls::help_meanings));
  Scene scene;
  CHECK(scene.controls.shows_help());
  scene.press(watch::Key::help);
  CHECK_FALSE(scene.controls.shows_help());
}

TEST_CASE("controls: N -> the run runs ahead to the next catch, which is played from 8 s before it with both in the picture") {
  Scene scene;
  scene.press(watch::Key::next_catch);
  CHECK(scene.controls.seeks_catch());
  CHECK(scene.controls.wanted_until_s() > 1e300);
  for (int i = 0; i < 10; ++i) {
    scene.written.advance();
    scene.look(0.02);
    scene.footage.forget_before(scene.controls.kept_from_s());
  }
  REQUIRE(scene.controls.seeks_catch());
  scene.footage.add_catch(
      {.time_s = 24.0, .hunter = 17, .victim = 18, .hunter_body = 0, .victim_body = 1, .sentence = "17 catches 18"});
  scene.look(0.0);
  REQUIRE(scene.controls.scene());
  CHECK(scene.controls.clock().time_s() == 16.0);
  CHECK(scene.controls.wanted_until_s() == 28.0);
  CHECK(watch::moment_text(scene.controls, scene.footage, false) == "16.0 s, 1x, 17 catches 18 (in 8 s)");
  for (const std::size_t body : {0U, 1U}) {
    const std::pair<double, double> at = scene.pixel(body);
    CHECK(at.first > 0.0);
    CHECK(at.first < scene.window.width);
  }
  for (int i = 0; i < 80; ++i) scene.look(0.1);
  CHECK(scene.controls.clock().time_s() == 24.0);
  CHECK(scene.controls.scene()->is_held(24.0));
  for (int i = 0; i < 11; ++i) scene.look(0.1);
  CHECK(scene.controls.clock().time_s() == 24.0);  // it stands still
  for (int i = 0; i < 4; ++i) scene.written.advance();
  for (int i = 0; i < 60 && scene.controls.scene(); ++i) scene.look(0.1);
  CHECK_FALSE(scene.controls.scene());
  CHECK(scene.controls.clock().is_paused());  // as before
}

TEST_CASE("controls: Esc while a catch is sought or played -> ends it and keeps the selection") {
  Scene scene;
  scene.press(watch::Key::next);
  scene.press(watch::Key::next_catch);
  scene.press(watch::Key::deselect);
  CHECK_FALSE(scene.controls.seeks_catch());
  CHECK(scene.controls.selected() == 17);
}
