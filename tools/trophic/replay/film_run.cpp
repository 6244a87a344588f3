// SPDX-License-Identifier: MIT
// Definitions of film_run.hpp.
#include <tools/trophic/replay/film_run.hpp>

#ifdef TROPHIC_WITH_FILM
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <iostream>
#include <stdexcept>
#include <string_view>
#include <tools/command/output.hpp>
#include <tools/film/camera.hpp>
#include <tools/film/encoder.hpp>
#include <tools/film/image.hpp>
#include <tools/film/renderer.hpp>
#include <tools/trophic/replay/director.hpp>
#include <tools/trophic/replay/footage.hpp>
#include <trophic/observe/progress.hpp>
#include <utility>
#include <vector>

namespace trophic::command::replay {

std::pair<std::size_t, std::size_t> two_numbers(std::string_view option, std::string_view text, std::size_t most) {
  std::pair<std::size_t, std::size_t> both{0, 0};
  const std::size_t cross = std::min(text.find('x'), text.size());
  const auto read = [&](std::string_view part, std::size_t& number) {
    const auto done = std::from_chars(part.data(), part.data() + part.size(), number);
    return done.ec == std::errc{} && done.ptr == part.data() + part.size() && number >= 1 && number <= most;
  };
  if (cross == text.size() || !read(text.substr(0, cross), both.first) || !read(text.substr(cross + 1), both.second)) {
    throw std::invalid_argument{std::string{option} + " " + std::string{text} +
                                ": must be two whole numbers such as 4x3, each from 1 to " + std::to_string(most)};
  }
  return both;
}

namespace {

/// "1234.0 s".
std::string time_text(double time_s) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.1f s", time_s);
  return text.data();
}

/// A picture's moment, and whose rows it shows: at the tick of a catch the victim's body has its successor already.
struct Moment {
  double time_s = 0.0;
  std::optional<double> rows_s;
};

/// Throws std::invalid_argument naming an option whose value is out of bounds.
void check(const FilmPlan& plan) {
  const bool is_film = film::is_film(plan.out);
  if (!is_film && plan.out.extension() != ".png") {
    throw std::invalid_argument{"--out " + plan.out.string() + ": must end in .png, .mp4, .webm or .gif"};
  }
  if (is_film && !plan.sheet.empty()) throw std::invalid_argument{"--sheet: needs --out with .png"};
  if (plan.catch_ && (plan.window.from_s || plan.window.to_s || plan.follow)) {
    throw std::invalid_argument{"--catch: not with --from, --to or --follow"};
  }
  check_new_file("--out", plan.out);
  if (plan.speed && !(*plan.speed > 0.0 && *plan.speed <= 1e4))
    throw std::invalid_argument{"--speed " + number_text(*plan.speed) + ": must be > 0 and <= 10000"};
  if (plan.fps < 1 || plan.fps > 120)
    throw std::invalid_argument{"--fps " + std::to_string(plan.fps) + ": must be >= 1 and <= 120"};
}

/// The stretch that is drawn: that of a catch, or what the plan says.
Window window_of(const FilmPlan& plan, const std::optional<Scene>& scene) {
  if (!scene) return plan.window;
  const bool is_moment = plan.out.extension() == ".png" && plan.sheet.empty();
  return is_moment ? Window{scene->time_s, scene->time_s} : Window{scene->begins_s, scene->ends_s};
}

/// The scene that a plan asks for. Throws std::invalid_argument if the run or its recording lacks it.
Scene find_scene(const RecordedRun& run, const std::string& which) {
  const auto refuse = [&](const std::string& why) { throw std::invalid_argument{"--catch " + which + ": " + why}; };
  std::vector<Scene> catches = catches_of(run);
  if (which == "best") {
    const std::vector<Scene> scenes = scenes_of(run, {});
    if (scenes.empty()) refuse(run.folder.string() + " has no recorded catch");
    return *best_of(scenes);
  }
  std::uint64_t number = 0;
  const auto done = std::from_chars(which.data(), which.data() + which.size(), number);
  if (done.ec != std::errc{} || done.ptr != which.data() + which.size() || number < 1) refuse("must be best, or a number from 1");
  if (number > catches.size()) {
    refuse(run.folder.string() + (catches.empty()       ? " has no catch"
                                  : catches.size() == 1 ? " has one catch"
                                                        : " has " + std::to_string(catches.size()) + " catches"));
  }
  Scene& scene = catches[number - 1];
  const double first_s = Window{}.start_s(run.recording);
  const double last_s = Window{}.end_s(run.recording);
  if (scene.time_s < first_s || scene.time_s > last_s) {
    refuse("is at " + number_text(scene.time_s) + " s, the recording is from " + number_text(first_s) + " to " +
           number_text(last_s) + " s");
  }
  stage(scene, catches, run, {});
  return scene;
}

/// Ecology seconds that a second of a film shows.
double speed_of(const FilmPlan& plan) {
  return plan.speed.value_or(plan.catch_ ? 1.0 : 10.0);
}

/// A narrower picture has neither title nor legend: they would hide it.
constexpr std::size_t least_width_of_texts = 560;

/// Draws the moments of one run as a plan says.
class Artist {
 public:
  Artist(const FilmPlan& plan, const RecordedRun& run, std::size_t width, std::size_t height)
      : plan_{plan},
        scene_{plan.catch_ ? std::optional{find_scene(run, *plan.catch_)} : std::nullopt},
        window_{window_of(plan, scene_)},
        from_s_{window_.start_s(run.recording)},
        to_s_{plan.out.extension() == ".png" && plan.sheet.empty() ? from_s_ : window_.end_s(run.recording)},
        footage_{run, from_s_, to_s_, flash_at(film::is_film(plan.out) ? speed_of(plan) : 0.0)},
        is_wide_{width >= least_width_of_texts},
        renderer_{run.recording.head().robot, run.recording.head().arena, width, height,
                  film::is_film(plan.out) && !plan.fine ? film::Quality::fast : film::Quality::fine} {
    if (plan.follow) followed_ = footage_.body_of(*plan.follow);
    const auto& head = run.recording.head();
    const std::string name = run.folder.lexically_normal().filename().string();
    title_ = plan.title.value_or((name.empty() ? run.folder.string() : name) + ": " + head.rule_table + ", " + head.backend +
                                 ", seed " + std::to_string(head.seed));
  }

  /// The catch that is shown, for the line that the program prints.
  [[nodiscard]] std::string subject() const {
    if (!scene_) return "";
    return "; at " + number_text(scene_->time_s) + " s " + scene_->sentence +
           (scene_->remark.empty() ? "" : " (" + scene_->remark + ")");
  }

  [[nodiscard]] film::Image draw(const Moment& moment) {
    Sights sights{.marked = plan_.follow, .rows_s = moment.rows_s, .has_lines = plan_.has_lines};
    if (scene_) {
      sights.named = {scene_->hunter.id, scene_->victim.id};
      sights.victim = scene_->victim.id;
      sights.hunter = scene_->hunter.id;
      sights.reach_m = scene_->reach_m;
    } else if (plan_.follow) {
      sights.named = {*plan_.follow};
    }
    film::Picture picture = footage_.picture(moment.time_s, sights);
    picture.is_small = scene_ && !is_wide_;
    picture.caption = picture.is_small ? moment_text(moment) : time_text(moment.time_s) + (scene_ ? "  " + scene_->sentence : "");
    if (is_wide_ && (plan_.has_legend || plan_.title)) picture.title = title_;
    if (is_wide_ && plan_.has_legend) {
      picture.legend = footage_.legend(moment.time_s, sights);
      picture.has_scale = true;
      if (!scene_ && !followed_) footage_.add_curves(picture, moment.time_s);
    }
    return renderer_.draw(picture, camera(moment.time_s, renderer_.aspect(picture)));
  }

  /// `count` moments, as far from each other as they can be. Those of a scene go from its beginning to the catch; the last is its
  /// end.
  [[nodiscard]] std::vector<Moment> sheet(std::size_t count) const {
    const std::size_t last = scene_ && count > 2 ? count - 2 : count - 1;  // the one at `until_s`
    const double until_s = scene_ ? scene_->time_s : to_s_;
    std::vector<Moment> moments;
    for (std::size_t i = 0; i <= last; ++i) {
      const double part = last == 0 ? 0.0 : static_cast<double>(i) / static_cast<double>(last);
      moments.push_back(scene_ && i == last ? still() : at(from_s_ + part * (until_s - from_s_)));
    }
    if (last + 1 < count) moments.push_back(at(to_s_));
    return moments;
  }

  /// Those of a film; a catch stands still for a moment.
  [[nodiscard]] std::vector<Moment> film() const {
    const double step_s = speed_of(plan_) / static_cast<double>(plan_.fps);
    const double pictures = std::floor((to_s_ - from_s_) / step_s + 1e-9) + 1.0;
    constexpr double most_pictures = 1e6;
    if (!(pictures <= most_pictures)) {
      throw std::invalid_argument{"--speed, --fps: a film of " + number_text(pictures) +
                                  " pictures: must have <= " + number_text(most_pictures)};
    }
    const auto count = static_cast<std::size_t>(pictures);
    std::vector<Moment> moments;
    bool is_caught = !scene_;
    for (std::size_t i = 0; i < count; ++i) {
      const double time_s = std::min(to_s_, from_s_ + static_cast<double>(i) * step_s);
      if (!is_caught && time_s >= scene_->time_s - 1e-9) {
        is_caught = true;
        moments.insert(moments.end(), static_cast<std::size_t>(std::ceil(Scene::still_s * static_cast<double>(plan_.fps))),
                       still());
      }
      moments.push_back(at(time_s));
    }
    return moments;
  }

  /// The moment that a picture shows.
  [[nodiscard]] Moment only() const { return scene_ ? still() : at(from_s_); }

 private:
  [[nodiscard]] static Moment at(double time_s) { return {time_s, {}}; }
  /// "4 s before", "caught, from within 1 m" or "3 s after".
  [[nodiscard]] std::string moment_text(const Moment& moment) const {
    if (moment.rows_s) return scene_->reach_m ? "caught, from within " + number_text(*scene_->reach_m) + " m" : "caught";
    const double from_catch_s = std::round(10.0 * (moment.time_s - scene_->time_s)) / 10.0;
    return number_text(std::abs(from_catch_s)) + (from_catch_s < 0.0 ? " s before" : " s after");
  }
  [[nodiscard]] Moment still() const { return {scene_->time_s, scene_->time_s - 0.5 * footage_.head().times.tick_s}; }
  [[nodiscard]] Eigen::Vector3d place(double time_s, std::size_t body) const { return footage_.root(time_s, body).position_m; }

  [[nodiscard]] film::Camera camera(double time_s, double aspect) const {
    film::Camera camera =
        plan_.from_above ? film::from_above(footage_.head().arena, aspect) : film::whole_arena(footage_.head().arena, aspect);
    if (scene_) {
      camera = scene_->shot.camera(aspect);
    } else if (followed_) {
      camera = film::near(footage_.head().robot, place(time_s, *followed_));
    }
    if (plan_.from_above) camera.elevation_deg = -90.0;
    return camera;
  }

  const FilmPlan& plan_;
  std::optional<Scene> scene_;
  Window window_;
  double from_s_;
  double to_s_;
  Footage footage_;
  bool is_wide_;
  film::Renderer renderer_;
  std::optional<std::size_t> followed_;
  std::string title_;
};

}  // namespace

int film_run(const FilmPlan& plan) {
  check(plan);
  const bool is_film = film::is_film(plan.out);
  const auto [width, height] = two_numbers("--size",
                                           !plan.size.empty()   ? plan.size
                                           : plan.sheet.empty() ? "1280x720"
                                                                : "480x360",
                                           4096);
  const auto [columns, rows] =
      plan.sheet.empty() ? std::pair<std::size_t, std::size_t>{1, 1} : two_numbers("--sheet", plan.sheet, 20);

  const RecordedRun run = open_run(plan.folder);
  for (const std::string& remark : run.remarks) std::cerr << "trophic film: " << remark << "\n";
  plan.window.check(run.recording);
  Artist artist{plan, run, width, height};
  std::string what = "1 picture";
  if (is_film) {
    film::Encoder encoder{plan.out, width, height, static_cast<double>(plan.fps)};
    const std::vector<Moment> moments = artist.film();
    for (const Moment& moment : moments) encoder.add(artist.draw(moment));
    encoder.finish();
    what = std::to_string(moments.size()) + (moments.size() == 1 ? " picture, " : " pictures, ") +
           observe::short_text(static_cast<double>(moments.size()) / static_cast<double>(plan.fps)) + " s";
  } else if (plan.sheet.empty()) {
    film::write_png(plan.out, artist.draw(artist.only()));
  } else {
    constexpr std::size_t gap = 6;
    film::Image sheet = film::Image::blank(columns * width + (columns - 1) * gap, rows * height + (rows - 1) * gap, 255);
    const std::vector<Moment> moments = artist.sheet(columns * rows);
    for (std::size_t i = 0; i < moments.size(); ++i) {
      film::put(sheet, artist.draw(moments[i]), i % columns * (width + gap), i / columns * (height + gap));
    }
    film::write_png(plan.out, sheet);
    what = std::to_string(moments.size()) + (moments.size() == 1 ? " picture" : " pictures");
  }
  std::cout << shown(plan.out) << ": " << what << artist.subject() << "\n";
  flush_output();
  return 0;
}

}  // namespace trophic::command::replay
#endif
