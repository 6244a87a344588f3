// SPDX-License-Identifier: MIT
// Effects of keys and mouse on the view. Independent of the window, which passes on the events.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <trophic/io/tables.hpp>
#include <trophic/pictures/drawing/camera.hpp>
#include <trophic/pictures/drawing/picture.hpp>
#include <trophic/pictures/watch/catch_scene.hpp>
#include <trophic/pictures/watch/clock.hpp>
#include <trophic/pictures/watch/eye.hpp>
#include <trophic/pictures/watch/live_footage.hpp>

namespace trophic::watch {

enum class Key { pause, step, faster, slower, follow, next, deselect, whole, top, help, next_catch };
enum class Button { turns, shifts };

/// The size of a window and a place in it, from its upper left corner, in the same units.
struct WindowSize {
  double width = 1280.0;
  double height = 720.0;
  [[nodiscard]] double aspect() const { return width / std::max(1.0, height); }
  [[nodiscard]] drawing::PicturePoint point(double x, double y) const {
    return {(2.0 * x - width) / height, (height - 2.0 * y) / height};
  }
};

class Controls {
 public:
  /// A mouse that moved less than this between press and release has clicked.
  static constexpr double click_reach = 4.0;

  static constexpr const char* help = "space\nright arrow\nup, down\nN\nclick\nF\nTab\nEsc\nA, T\ndrag, wheel\nright drag\nH\nQ";
  static constexpr const char* help_meanings =
      "pause, resume\none tick\nfaster, slower\nthe next catch, from some seconds before it\nselect a robot\nfollow it\nselect "
      "the next one\nselect none\nwhole arena, from "
      "above\n"
      "turn, zoom\nmove\nthis help\nclose; the run continues";

  /// `elapsed_s` of real time have passed. Called before each drawing.
  void advance(const LiveFootage& footage, double elapsed_s, const WindowSize& window) {
    if (!is_begun_) {
      is_begun_ = true;
      clock_.set(footage.first_s());
      eye_.see_whole(footage.arena(), window.aspect());
    }
    tick_s_ = footage.tick_s();
    if (scene_ || wanted_after_s_) {
      advance_scene(footage, elapsed_s);
    } else {
      clock_.advance(elapsed_s, footage.newest_s());
    }
    if (selected_ && lives(footage)) {
      if (is_following_) eye_.look_at(footage.root(clock_.time_s(), body_).position_m);
    }
  }

  void press(Key key, const LiveFootage& footage, const WindowSize& window) {
    if (key != Key::help && key != Key::next_catch && (scene_ || wanted_after_s_)) {
      leave_scene();
      if (key == Key::deselect) return;
    }
    switch (key) {
      case Key::next_catch:
        return seek_catch();
      case Key::pause:
        return clock_.pause_or_continue();
      case Key::step:
        return clock_.step(footage.tick_s());
      case Key::faster:
        return clock_.faster();
      case Key::slower:
        return clock_.slower();
      case Key::follow:
        return follow(footage, window);
      case Key::next:
        return select_next(footage);
      case Key::deselect:
        return let_go();
      case Key::whole:
        is_following_ = false;
        return eye_.see_whole(footage.arena(), window.aspect());
      case Key::top:
        is_following_ = false;
        return eye_.see_from_above(footage.arena(), window.aspect());
      case Key::help:
        shows_help_ = !shows_help_;
        return;
    }
  }

  void press_mouse(Button button, double x, double y) { mouse_ = Mouse{.button = button, .x = x, .y = y, .moved = 0.0}; }
  void move_mouse(double x, double y, const WindowSize& window) {
    if (!mouse_) return;
    const double right = (x - mouse_->x) / window.height;
    const double up = (mouse_->y - y) / window.height;
    mouse_->moved += std::hypot(x - mouse_->x, y - mouse_->y);
    mouse_->x = x;
    mouse_->y = y;
    if (mouse_->moved < click_reach) return;
    if (mouse_->button == Button::turns) return eye_.turn(right, up);
    is_following_ = false;
    eye_.shift(right, up);
  }
  void release_mouse(const LiveFootage& footage, const WindowSize& window) {
    if (mouse_ && mouse_->button == Button::turns && mouse_->moved < click_reach) {
      click(footage, window.point(mouse_->x, mouse_->y));
    }
    mouse_.reset();
  }
  void turn_wheel(double notches) { eye_.zoom(notches); }

  [[nodiscard]] const Clock& clock() const { return clock_; }
  [[nodiscard]] const drawing::Camera& camera() const { return eye_.camera(); }
  [[nodiscard]] std::optional<IndividualId> selected() const { return selected_; }
  [[nodiscard]] bool is_following() const { return is_following_; }
  [[nodiscard]] bool shows_help() const { return shows_help_; }
  [[nodiscard]] double wanted_until_s() const {
    if (wanted_after_s_) return std::numeric_limits<double>::infinity();
    if (scene_) return scene_->ends_s();
    return clock_.wanted_until_s(tick_s_);
  }
  /// The catch that is played.
  [[nodiscard]] const std::optional<CatchScene>& scene() const { return scene_; }
  /// Whether the run runs ahead to its next catch.
  [[nodiscard]] bool seeks_catch() const { return wanted_after_s_.has_value(); }
  /// Moment from which frames are needed.
  [[nodiscard]] double kept_from_s() const { return clock_.time_s() - CatchScene::before_s; }

  /// The body of the selected individual; `nullopt` if none is selected or it has died.
  [[nodiscard]] std::optional<std::size_t> selected_body(const LiveFootage& footage) const {
    return selected_ && lives(footage) ? std::optional{body_} : std::nullopt;
  }

 private:
  struct Mouse {
    Button button;
    double x, y, moved;
  };

  void seek_catch() {
    wanted_after_s_ = scene_ ? scene_->shown().time_s : clock_.time_s();
    if (!scene_) was_paused_ = clock_.is_paused();
    scene_.reset();
  }
  /// The clock continues from the end of the scene, as it ran before.
  void leave_scene() {
    scene_.reset();
    wanted_after_s_.reset();
    clock_.set_paused(was_paused_);
  }
  /// Runs ahead to the next catch, then plays it with both robots in the picture.
  void advance_scene(const LiveFootage& footage, double elapsed_s) {
    if (wanted_after_s_) {
      const auto found = std::ranges::find_if(footage.catches(), [&](const Catch& one) { return one.time_s > *wanted_after_s_; });
      if (found == footage.catches().end()) return clock_.set(footage.newest_s());
      wanted_after_s_.reset();
      scene_.emplace(*found);
      clock_.set(std::max(footage.first_s(), scene_->begins_s()));
    }
    clock_.set(scene_->advance(clock_.time_s(), elapsed_s, footage.newest_s()));
    const double time_s = clock_.time_s();
    const Catch& one = scene_->shown();
    const Eigen::Vector3d hunter = footage.root(time_s, one.hunter_body).position_m;
    const Eigen::Vector3d victim = footage.root(time_s, one.victim_body).position_m;
    eye_.come_near(footage.robot(), 0.5 * (hunter + victim));
    eye_.keep_in_view((hunter - victim).norm());
    if (time_s >= scene_->ends_s()) leave_scene();
  }

  [[nodiscard]] bool lives(const LiveFootage& footage) const {
    const auto rows = footage.rows_at(clock_.time_s());
    return body_ < rows.size() && rows[body_].id == *selected_;
  }
  void select(const LiveFootage& footage, std::size_t body) {
    body_ = body;
    selected_ = footage.rows_at(clock_.time_s())[body].id;
  }
  void let_go() {
    selected_.reset();
    is_following_ = false;
  }

  /// Selects the robot whose ring is clicked; a click elsewhere deselects.
  void click(const LiveFootage& footage, const drawing::PicturePoint& point) {
    const auto at = drawing::floor_at(eye_.camera(), point);
    let_go();
    if (!at) return;
    double nearest_m = 1.5 * drawing::ring_radius_m(footage.robot(), footage.arena());
    for (std::size_t body = 0; body < footage.rows_at(clock_.time_s()).size(); ++body) {
      const double away_m = (footage.root(clock_.time_s(), body).position_m.head<2>() - *at).norm();
      if (away_m >= nearest_m) continue;
      nearest_m = away_m;
      select(footage, body);
    }
  }
  void select_next(const LiveFootage& footage) {
    const std::size_t bodies = footage.rows_at(clock_.time_s()).size();
    if (bodies != 0) select(footage, selected_ ? (body_ + 1) % bodies : 0);
  }
  void follow(const LiveFootage& footage, const WindowSize& window) {
    if (is_following_) {
      is_following_ = false;
      return eye_.see_whole(footage.arena(), window.aspect());
    }
    if (!selected_ || !lives(footage)) return;
    is_following_ = true;
    eye_.come_near(footage.robot(), footage.root(clock_.time_s(), body_).position_m);
  }

  Clock clock_;
  Eye eye_;
  std::optional<Mouse> mouse_;
  std::optional<CatchScene> scene_;
  std::optional<double> wanted_after_s_;  ///< the next catch is to be later
  bool was_paused_ = false;               ///< before the scene
  std::optional<IndividualId> selected_;
  std::size_t body_ = 0;
  double tick_s_ = 1.0;
  bool is_begun_ = false;
  bool is_following_ = false;
  bool shows_help_ = true;
};

}  // namespace trophic::watch
