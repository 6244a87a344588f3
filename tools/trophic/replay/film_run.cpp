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
#include <memory>
#include <span>
#include <stdexcept>
#include <string_view>
#include <tools/analysis/data/csv_reader.hpp>
#include <tools/command/output.hpp>
#include <tools/trophic/replay/catch_scene.hpp>
#include <tools/trophic/replay/recorded_agents.hpp>
#include <trophic/observe/progress.hpp>
#include <trophic/pictures/drawing/camera.hpp>
#include <trophic/pictures/drawing/footage.hpp>
#include <trophic/pictures/film/encoder.hpp>
#include <trophic/pictures/film/image.hpp>
#include <trophic/pictures/film/renderer.hpp>
#include <tuple>
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

/// A stretch of a recorded run.
class RecordedFootage {
 public:
  /// Throws std::invalid_argument for tables that are not the run's.
  RecordedFootage(const RecordedRun& run, double from_s, double to_s, double flash_s)
      : recording_{run.recording}, agents_{run, from_s, to_s, drawing::trail_s}, from_s_{from_s}, to_s_{to_s}, flash_s_{flash_s} {
    const auto tags = run.manifest.at("tags").get<std::vector<int>>();
    filled_tag_ = *std::ranges::max_element(tags);
    species_ = run.manifest.at("species").get<std::vector<std::string>>();
    read_deaths(run);
  }

  [[nodiscard]] std::span<const io::AgentRow> rows_at(double time_s) const { return agents_.at(time_s); }
  [[nodiscard]] std::shared_ptr<const RobotModel> robot_in(double time_s, std::size_t body) const {
    if (!recording_.head().bodies_differ) return nullptr;
    return {std::shared_ptr<void>{}, &recording_.robot(recording_.frame_at(time_s), body)};  // the recording owns it
  }
  [[nodiscard]] Pose root(double time_s, std::size_t body) const {
    const auto [before, after, part] = around(time_s, body);
    return drawing::between(recording_.root(before, body), recording_.root(after, body), part);
  }
  [[nodiscard]] std::vector<double> joint_angles_rad(double time_s, std::size_t body) const {
    const auto [before, after, part] = around(time_s, body);
    const auto& head = recording_.head();
    const std::size_t joints = head.bodies_differ ? recording_.robot(before, body).hinges.size() : head.joints;
    std::vector<double> angles;
    for (std::size_t joint = 0; joint < joints; ++joint) {
      const double a = recording_.joint_angle_rad(before, body, joint);
      angles.push_back(a + part * (recording_.joint_angle_rad(after, body, joint) - a));
    }
    return angles;
  }
  [[nodiscard]] std::span<const drawing::Death> deaths() const { return deaths_; }
  [[nodiscard]] const RobotModel& robot() const { return recording_.head().robot; }
  [[nodiscard]] const Arena& arena() const { return recording_.head().arena; }
  [[nodiscard]] double tick_s() const { return recording_.head().times.tick_s; }
  [[nodiscard]] double first_s() const { return recording_.head().first_time_s; }
  [[nodiscard]] int filled_tag() const { return filled_tag_; }
  [[nodiscard]] const std::vector<std::string>& species() const { return species_; }

  /// The body in which an individual lives. Throws std::invalid_argument for one that does not live in the stretch.
  [[nodiscard]] std::size_t body_of(IndividualId id) const {
    const auto ticks = static_cast<std::size_t>(std::ceil((to_s_ - from_s_) / tick_s() - 1e-9));
    for (std::size_t tick = 0; tick <= ticks; ++tick) {
      const auto rows = agents_.at(std::min(to_s_, from_s_ + static_cast<double>(tick) * tick_s()));
      const auto found = std::ranges::find(rows, id, &io::AgentRow::id);
      if (found != rows.end()) return static_cast<std::size_t>(found - rows.begin());
    }
    throw std::invalid_argument{"--follow " + std::to_string(id) + ": no individual of that id lives between " +
                                number_text(from_s_) + " and " + number_text(to_s_) + " s"};
  }

 private:
  void read_deaths(const RecordedRun& run) {
    analysis::CsvReader events{run.folder / "events.csv", {"time_s", "event", "x_m", "y_m", "cause"}};
    while (events.next()) {
      const auto time_s = events.get<double>(0);
      if (events.text(1) != "death" || time_s < from_s_ - flash_s_ || time_s > to_s_) continue;
      deaths_.push_back({time_s, events.get<double>(2), events.get<double>(3), events.text(4) == "caught"});
    }
  }

  /// The frames before and after a moment, and how far it is between them; the same one before a newborn's body is set down.
  [[nodiscard]] std::tuple<std::size_t, std::size_t, double> around(double time_s, std::size_t body) const {
    const std::size_t before = recording_.frame_at(time_s);
    const std::size_t next = std::min(before + 1, recording_.frames() - 1);
    const std::size_t after = recording_.is_set_down(next, body) ? before : next;
    const double gap_s = recording_.time_s(after) - recording_.time_s(before);
    return {before, after, gap_s > 0.0 ? (time_s - recording_.time_s(before)) / gap_s : 0.0};
  }

  const io::RecordingReader& recording_;
  RecordedAgents agents_;
  double from_s_;
  double to_s_;
  double flash_s_;
  int filled_tag_ = 1;
  std::vector<drawing::Death> deaths_;
  std::vector<std::string> species_;
};
static_assert(drawing::Footage<RecordedFootage>);

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
Window window_of(const FilmPlan& plan, const RecordedRun& run, const std::optional<CatchScene>& scene) {
  if (!scene) return plan.window;
  const double first_s = Window{}.start_s(run.recording);
  const double last_s = Window{}.end_s(run.recording);
  if (scene->time_s < first_s || scene->time_s > last_s) {
    throw std::invalid_argument{"--catch " + std::to_string(*plan.catch_) + ": is at " + number_text(scene->time_s) +
                                " s, the recording is from " + number_text(first_s) + " to " + number_text(last_s) + " s"};
  }
  const bool is_moment = plan.out.extension() == ".png" && plan.sheet.empty();
  return {is_moment ? scene->time_s : std::max(first_s, scene->time_s - CatchScene::before_s),
          std::min(last_s, scene->time_s + (is_moment ? 0.0 : CatchScene::after_s))};
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
        scene_{plan.catch_ ? std::optional{find_catch(run, *plan.catch_)} : std::nullopt},
        window_{window_of(plan, run, scene_)},
        from_s_{window_.start_s(run.recording)},
        to_s_{plan.out.extension() == ".png" && plan.sheet.empty() ? from_s_ : window_.end_s(run.recording)},
        flash_s_{film::is_film(plan.out) ? drawing::flash_at(speed_of(plan)) : drawing::flash_s},
        footage_{run, from_s_, to_s_, flash_s_},
        is_wide_{width >= least_width_of_texts},
        aspect_{static_cast<double>(width) / static_cast<double>(height)},
        renderer_{run.recording.head().robot, run.recording.head().arena, width, height,
                  film::is_film(plan.out) && !plan.fine ? film::Quality::fast : film::Quality::fine} {
    if (plan.follow) followed_ = footage_.body_of(*plan.follow);
    const auto& head = run.recording.head();
    const std::string name = run.folder.lexically_normal().filename().string();
    title_ = plan.title.value_or((name.empty() ? run.folder.string() : name) + ": " + head.rule_table + ", " + head.backend +
                                 ", seed " + std::to_string(head.seed));
    if (!scene_) return;
    for (double time_s = from_s_; time_s <= scene_->time_s + 1e-9; time_s += 0.5) {
      apart_m_ = std::max(apart_m_, (place(time_s, scene_->hunter_body) - place(time_s, scene_->victim_body)).norm());
    }
  }

  [[nodiscard]] double from_s() const { return from_s_; }

  [[nodiscard]] drawing::Image draw(const Moment& moment) {
    drawing::Sights sights{.marked = plan_.follow,
                           .rows_s = moment.rows_s,
                           .species = footage_.species(),
                           .has_lines = plan_.has_lines,
                           .flash_s = flash_s_};
    std::string caption = time_text(moment.time_s);
    if (scene_) {
      sights.marked = scene_->hunter;
      sights.named = {scene_->hunter, scene_->victim};
      caption += "  " + scene_->sentence;
    } else if (plan_.follow) {
      sights.named = {*plan_.follow};
    }
    drawing::Picture picture = drawing::picture_of(footage_, moment.time_s, sights, std::move(caption));
    if (!is_wide_) return renderer_.draw(picture, camera(moment.time_s));
    if (plan_.has_legend || plan_.title) picture.title = title_;
    if (plan_.has_legend) {
      picture.legend = drawing::legend_of(footage_.species(), footage_.rows_at(moment.rows_s.value_or(moment.time_s)),
                                          footage_.filled_tag(), plan_.has_lines);
      picture.has_scale = true;
    }
    return renderer_.draw(picture, camera(moment.time_s));
  }

  /// `count` moments, as far from each other as they can be; the last but one third of a catch's is the catch itself.
  [[nodiscard]] std::vector<Moment> sheet(std::size_t count) const {
    std::vector<Moment> moments;
    for (std::size_t i = 0; i < count; ++i) {
      const double part = count == 1 ? 0.0 : static_cast<double>(i) / static_cast<double>(count - 1);
      moments.push_back(at(from_s_ + part * (to_s_ - from_s_)));
    }
    if (!scene_ || count == 1) return moments;
    const auto nearest =
        std::ranges::min_element(moments, {}, [&](const Moment& one) { return std::abs(one.time_s - scene_->time_s); });
    *nearest = still();
    return moments;
  }

  /// Those of a film; a catch stands still for a moment.
  [[nodiscard]] std::vector<Moment> film() const {
    const double step_s = speed_of(plan_) / static_cast<double>(plan_.fps);
    const auto count = static_cast<std::size_t>(std::floor((to_s_ - from_s_) / step_s + 1e-9)) + 1;
    std::vector<Moment> moments;
    bool is_caught = !scene_;
    for (std::size_t i = 0; i < count; ++i) {
      const double time_s = std::min(to_s_, from_s_ + static_cast<double>(i) * step_s);
      if (!is_caught && time_s >= scene_->time_s - 1e-9) {
        is_caught = true;
        moments.insert(moments.end(), static_cast<std::size_t>(std::ceil(CatchScene::still_s * static_cast<double>(plan_.fps))),
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
  [[nodiscard]] Moment still() const { return {scene_->time_s, scene_->time_s - 0.5 * footage_.tick_s()}; }
  [[nodiscard]] Eigen::Vector3d place(double time_s, std::size_t body) const { return footage_.root(time_s, body).position_m; }

  [[nodiscard]] drawing::Camera camera(double time_s) const {
    drawing::Camera camera =
        plan_.from_above ? drawing::from_above(footage_.arena(), aspect_) : drawing::whole_arena(footage_.arena(), aspect_);
    if (scene_) {
      camera = drawing::near_pair(footage_.robot(), place(time_s, scene_->hunter_body), place(time_s, scene_->victim_body),
                                  apart_m_, aspect_);
    } else if (followed_) {
      camera = drawing::near(footage_.robot(), place(time_s, *followed_));
    }
    if (plan_.from_above) camera.elevation_deg = -90.0;
    return camera;
  }

  const FilmPlan& plan_;
  std::optional<CatchScene> scene_;
  Window window_;
  double from_s_;
  double to_s_;
  double flash_s_;
  RecordedFootage footage_;
  bool is_wide_;
  double aspect_;
  film::Renderer renderer_;
  std::optional<std::size_t> followed_;
  std::string title_;
  double apart_m_ = 0.0;
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
    drawing::Image sheet = drawing::Image::blank(columns * width + (columns - 1) * gap, rows * height + (rows - 1) * gap, 255);
    const std::vector<Moment> moments = artist.sheet(columns * rows);
    for (std::size_t i = 0; i < moments.size(); ++i) {
      film::put(sheet, artist.draw(moments[i]), i % columns * (width + gap), i / columns * (height + gap));
    }
    film::write_png(plan.out, sheet);
    what = std::to_string(moments.size()) + (moments.size() == 1 ? " picture" : " pictures");
  }
  std::cout << plan.out.string() << ": " << what << "\n";
  flush_output();
  return 0;
}

}  // namespace trophic::command::replay
#endif
