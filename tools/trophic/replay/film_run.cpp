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
#include <span>
#include <stdexcept>
#include <string_view>
#include <tools/analysis/data/csv_reader.hpp>
#include <tools/trophic/replay/recorded_agents.hpp>
#include <trophic/command/output.hpp>
#include <trophic/pictures/drawing/camera.hpp>
#include <trophic/pictures/drawing/footage.hpp>
#include <trophic/pictures/film/encoder.hpp>
#include <trophic/pictures/film/image.hpp>
#include <trophic/pictures/film/renderer.hpp>
#include <tuple>
#include <utility>
#include <vector>

namespace trophic::command::replay {

namespace {

/// "1280x720" as two numbers. Throws std::invalid_argument naming the option.
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

/// A stretch of a recorded run.
class RecordedFootage {
 public:
  /// Throws std::invalid_argument for tables that are not the run's.
  RecordedFootage(const RecordedRun& run, double from_s, double to_s)
      : recording_{run.recording}, agents_{run, from_s, to_s, drawing::trail_s}, from_s_{from_s}, to_s_{to_s} {
    const auto tags = run.manifest.at("tags").get<std::vector<int>>();
    filled_tag_ = *std::ranges::max_element(tags);
    read_deaths(run);
  }

  [[nodiscard]] std::span<const io::AgentRow> rows_at(double time_s) const { return agents_.at(time_s); }
  [[nodiscard]] Pose root(double time_s, std::size_t body) const {
    const auto [before, after, part] = around(time_s);
    return drawing::between(recording_.root(before, body), recording_.root(after, body), part);
  }
  [[nodiscard]] std::vector<double> joint_angles_rad(double time_s, std::size_t body) const {
    const auto [before, after, part] = around(time_s);
    std::vector<double> angles;
    for (std::size_t joint = 0; joint < recording_.head().joints; ++joint) {
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
    analysis::CsvReader events{run.folder / "events.csv", {"time_s", "event", "x_m", "y_m"}};
    while (events.next()) {
      const auto time_s = events.get<double>(0);
      if (events.text(1) != "death" || time_s < from_s_ - drawing::flash_s || time_s > to_s_) continue;
      deaths_.push_back({time_s, events.get<double>(2), events.get<double>(3)});
    }
  }

  /// The frames before and after a moment, and how far it is between them.
  [[nodiscard]] std::tuple<std::size_t, std::size_t, double> around(double time_s) const {
    const std::size_t before = recording_.frame_at(time_s);
    const std::size_t after = std::min(before + 1, recording_.frames() - 1);
    const double gap_s = recording_.time_s(after) - recording_.time_s(before);
    return {before, after, gap_s > 0.0 ? (time_s - recording_.time_s(before)) / gap_s : 0.0};
  }

  const io::RecordingReader& recording_;
  RecordedAgents agents_;
  double from_s_;
  double to_s_;
  int filled_tag_ = 1;
  std::vector<drawing::Death> deaths_;
};
static_assert(drawing::Footage<RecordedFootage>);

/// "1234.0 s".
std::string time_text(double time_s) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.1f s", time_s);
  return text.data();
}

}  // namespace

int film_run(const FilmPlan& plan) {
  const bool is_film = plan.out.extension() == ".mp4";
  if (!is_film && plan.out.extension() != ".png")
    throw std::invalid_argument{"--out " + plan.out.string() + ": must end in .png or .mp4"};
  if (is_film && !plan.sheet.empty()) throw std::invalid_argument{"--sheet: needs --out with .png"};
  check_new_file("--out", plan.out);
  if (!(plan.speed > 0.0 && plan.speed <= 1e4))
    throw std::invalid_argument{"--speed " + number_text(plan.speed) + ": must be > 0 and <= 10000"};
  if (plan.fps < 1 || plan.fps > 120)
    throw std::invalid_argument{"--fps " + std::to_string(plan.fps) + ": must be >= 1 and <= 120"};
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
  const double from_s = plan.window.start_s(run.recording);
  const bool is_moment = !is_film && plan.sheet.empty();
  const double to_s = is_moment ? from_s : plan.window.end_s(run.recording);
  const RecordedFootage footage{run, from_s, to_s};
  const auto followed = plan.follow ? std::optional{footage.body_of(*plan.follow)} : std::nullopt;

  constexpr std::size_t gap = 6;
  const film::Quality quality = is_film && !plan.fine ? film::Quality::fast : film::Quality::fine;
  film::Renderer renderer{run.recording.head().robot, run.recording.head().arena, width, height, quality};
  const double aspect = static_cast<double>(width) / static_cast<double>(height);
  const auto draw = [&](double time_s) {
    drawing::Camera camera =
        plan.from_above ? drawing::from_above(footage.arena(), aspect) : drawing::whole_arena(footage.arena(), aspect);
    if (followed) camera = drawing::near(footage.robot(), footage.root(time_s, *followed).position_m);
    if (followed && plan.from_above) camera.elevation_deg = -90.0;
    return renderer.draw(drawing::picture_of(footage, time_s, plan.follow, time_text(time_s)), camera);
  };
  std::size_t pictures = 1;
  if (is_moment) {
    film::write_png(plan.out, draw(from_s));
  } else if (!is_film) {
    drawing::Image sheet = drawing::Image::blank(columns * width + (columns - 1) * gap, rows * height + (rows - 1) * gap, 255);
    pictures = columns * rows;
    for (std::size_t i = 0; i < pictures; ++i) {
      const double part = pictures == 1 ? 0.0 : static_cast<double>(i) / static_cast<double>(pictures - 1);
      film::put(sheet, draw(from_s + part * (to_s - from_s)), i % columns * (width + gap), i / columns * (height + gap));
    }
    film::write_png(plan.out, sheet);
  } else {
    film::Encoder encoder{plan.out, width, height, static_cast<double>(plan.fps)};
    const double step_s = plan.speed / static_cast<double>(plan.fps);
    pictures = static_cast<std::size_t>(std::floor((to_s - from_s) / step_s + 1e-9)) + 1;
    for (std::size_t i = 0; i < pictures; ++i) encoder.add(draw(std::min(to_s, from_s + static_cast<double>(i) * step_s)));
    encoder.finish();
  }
  std::cout << plan.out.string() << ": " << pictures << (pictures == 1 ? " picture" : " pictures") << "\n";
  flush_output();
  return 0;
}

}  // namespace trophic::command::replay
#endif
