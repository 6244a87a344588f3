// SPDX-License-Identifier: MIT
// From a recorded run to what a renderer draws, moment by moment, and into a file.
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <trophic/command/output.hpp>
#include <trophic/command/replay/recorded_agents.hpp>
#include <trophic/command/replay/recorded_run.hpp>
#include <trophic/film/encoder.hpp>
#include <trophic/film/image.hpp>
#include <trophic/film/renderer.hpp>
#include <utility>
#include <vector>

namespace trophic::command::replay {

/// What is to be drawn.
struct FilmPlan {
  std::filesystem::path folder;
  std::filesystem::path out;
  Window window;
  std::optional<std::uint64_t> follow;
  std::string sheet;
  std::string size;  ///< of each picture; empty: 1280x720, in a sheet 480x360
  bool from_above = false;
  double speed = 10.0;
  std::uint64_t fps = 30;
  bool fine = false;
};

/// "1280x720" as two numbers. Throws std::invalid_argument naming the option.
[[nodiscard]] inline std::pair<std::size_t, std::size_t> two_numbers(std::string_view option, std::string_view text,
                                                                     std::size_t most) {
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

/// Okabe and Ito's colours, as the page in the browser has them.
[[nodiscard]] inline film::Colour colour_of(Species species) {
  static constexpr std::array<std::array<int, 3>, 7> colours{
      {{0, 114, 178}, {213, 94, 0}, {0, 158, 115}, {204, 121, 167}, {230, 159, 0}, {86, 180, 233}, {122, 92, 0}}};
  const auto& c = colours[species % colours.size()];
  return {static_cast<float>(c[0]) / 255.0F, static_cast<float>(c[1]) / 255.0F, static_cast<float>(c[2]) / 255.0F};
}
inline constexpr film::Colour inactive_colour{0.6F, 0.63F, 0.66F};

/// What a run looks like at any moment of a stretch.
class FilmedRun {
 public:
  static constexpr double trail_s = 60.0;
  static constexpr double flash_s = 6.0;

  /// Throws std::invalid_argument for a robot that does not live in the stretch.
  FilmedRun(const RecordedRun& run, double from_s, double to_s, std::optional<std::uint64_t> follow)
      : recording_{run.recording}, agents_{run, from_s, to_s, trail_s}, follow_{follow} {
    const auto tags = run.manifest.at("tags").get<std::vector<int>>();
    filled_tag_ = *std::ranges::max_element(tags);
    read_deaths(run, from_s, to_s);
    if (follow_) find_followed(from_s, to_s);
  }

  [[nodiscard]] film::Picture picture(double time_s, const std::string& caption) const {
    film::Picture picture;
    picture.caption = caption;
    const auto rows = agents_.at(time_s);
    const std::size_t joints = recording_.head().joints;
    for (std::size_t body = 0; body < rows.size(); ++body) {
      film::RobotLook look;
      look.root = root(time_s, body);
      for (std::size_t joint = 0; joint < joints; ++joint) look.joint_angles_rad.push_back(angle(time_s, body, joint));
      look.colour = colour(rows[body]);
      look.filled = rows[body].tag == filled_tag_;
      look.is_marked = follow_ && rows[body].id == *follow_;
      picture.robots.push_back(std::move(look));
      add_trail(picture, time_s, body);
    }
    add_sights(picture, rows);
    for (const auto& death : deaths_) {
      const double age = (time_s - death.time_s) / flash_s;
      if (age < 0.0 || age >= 1.0) continue;
      const double ring_m =
          std::max(1.15 * recording_.head().robot.bounding_radius_m, 0.021 * recording_.head().arena.half_side_m);
      picture.flashes.push_back({death.x_m, death.y_m, ring_m * (1.2 + 2.2 * age)});
    }
    return picture;
  }

  /// Where the followed individual is, or, when it does not live, where its body is.
  [[nodiscard]] Eigen::Vector3d followed(double time_s) const { return root(time_s, followed_body_).position_m; }

 private:
  struct Death {
    double time_s, x_m, y_m;
  };

  void read_deaths(const RecordedRun& run, double from_s, double to_s) {
    analysis::CsvReader events{run.folder / "events.csv", {"time_s", "event", "x_m", "y_m"}};
    while (events.next()) {
      const auto time_s = events.get<double>(0);
      if (events.text(1) != "death" || time_s < from_s - flash_s || time_s > to_s) continue;
      deaths_.push_back({time_s, events.get<double>(2), events.get<double>(3)});
    }
  }

  void find_followed(double from_s, double to_s) {
    for (double time_s = from_s; time_s <= to_s + 1e-9; time_s += recording_.head().times.tick_s) {
      const auto rows = agents_.at(time_s);
      const auto found = std::ranges::find(rows, *follow_, &observe::AgentRow::id);
      if (found == rows.end()) continue;
      followed_body_ = static_cast<std::size_t>(found - rows.begin());
      return;
    }
    throw std::invalid_argument{"--follow " + std::to_string(*follow_) + ": nobody of that id lives between " +
                                number_text(from_s) + " and " + number_text(to_s) + " s"};
  }

  /// The frames before and after a moment, and how far it is between them.
  [[nodiscard]] std::tuple<std::size_t, std::size_t, double> between(double time_s) const {
    const std::size_t before = recording_.frame_at(time_s);
    const std::size_t after = std::min(before + 1, recording_.frames() - 1);
    const double gap_s = recording_.time_s(after) - recording_.time_s(before);
    return {before, after, gap_s > 0.0 ? (time_s - recording_.time_s(before)) / gap_s : 0.0};
  }
  [[nodiscard]] Pose root(double time_s, std::size_t body) const {
    const auto [before, after, part] = between(time_s);
    const Pose a = recording_.root(before, body);
    const Pose b = recording_.root(after, body);
    return {a.position_m + part * (b.position_m - a.position_m), a.orientation.slerp(part, b.orientation)};
  }
  [[nodiscard]] double angle(double time_s, std::size_t body, std::size_t joint) const {
    const auto [before, after, part] = between(time_s);
    const double a = recording_.joint_angle_rad(before, body, joint);
    return a + part * (recording_.joint_angle_rad(after, body, joint) - a);
  }

  [[nodiscard]] static film::Colour colour(const observe::AgentRow& row) {
    return row.active ? colour_of(row.species) : inactive_colour;
  }

  void add_trail(film::Picture& picture, double time_s, std::size_t body) const {
    const double step_s = 2.0 * recording_.head().times.tick_s;
    const double oldest_s = std::max(recording_.head().first_time_s, time_s - trail_s);
    Eigen::Vector3d to = root(time_s, body).position_m;
    for (double then_s = std::floor(time_s / step_s - 1e-9) * step_s; then_s >= oldest_s; then_s -= step_s) {
      const auto& row = agents_.at(then_s)[body];
      const auto strength = static_cast<float>(0.8 * (1.0 - (time_s - then_s) / trail_s));
      picture.lines.push_back({to.x(), to.y(), row.x_m, row.y_m, colour(row), strength});
      to = {row.x_m, row.y_m, 0.0};
    }
  }

  void add_sights(film::Picture& picture, std::span<const observe::AgentRow> rows) const {
    for (std::size_t body = 0; body < rows.size(); ++body) {
      if (!rows[body].adversary) continue;
      const auto other = std::ranges::find(rows, *rows[body].adversary, &observe::AgentRow::id);
      if (other == rows.end()) continue;
      const Eigen::Vector3d from = picture.robots[body].root.position_m;
      const Eigen::Vector3d to = picture.robots[static_cast<std::size_t>(other - rows.begin())].root.position_m;
      picture.lines.push_back({from.x(), from.y(), to.x(), to.y(), colour(rows[body]), 0.22F});
    }
  }

  const observe::RecordingReader& recording_;
  RecordedAgents agents_;
  std::optional<std::uint64_t> follow_;
  std::size_t followed_body_ = 0;
  int filled_tag_ = 1;
  std::vector<Death> deaths_;
};

/// "1234.0 s".
[[nodiscard]] inline std::string time_text(double time_s) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.1f s", time_s);
  return text.data();
}

/// Draws what the plan says into its file and tells of it. Throws std::invalid_argument for what is wrong with the plan or the
/// run, std::runtime_error for what goes wrong later.
[[nodiscard]] inline int film_run(const FilmPlan& plan) {
  const bool is_film = plan.out.extension() == ".mp4";
  if (!is_film && plan.out.extension() != ".png")
    throw std::invalid_argument{"--out " + plan.out.string() + ": must end in .png or .mp4"};
  if (is_film && !plan.sheet.empty()) throw std::invalid_argument{"--sheet: needs --out with .png"};
  if (std::filesystem::exists(std::filesystem::symlink_status(plan.out))) {
    throw std::invalid_argument{"--out " + plan.out.string() + ": exists already; nothing is overwritten"};
  }
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
  const double last_s = run.recording.time_s(run.recording.frames() - 1);
  const double from_s = plan.window.from_s.value_or(run.recording.head().first_time_s);
  const bool is_moment = !is_film && plan.sheet.empty();
  const double to_s = is_moment ? from_s : plan.window.to_s.value_or(last_s);
  const FilmedRun filmed{run, from_s, to_s, plan.follow};

  constexpr std::size_t gap = 6;
  const film::Quality quality = is_film && !plan.fine ? film::Quality::fast : film::Quality::fine;
  film::Renderer renderer{run.recording.head().robot, run.recording.head().arena, width, height, quality};
  const auto draw = [&](double time_s) {
    film::Camera camera = plan.from_above ? renderer.from_above() : renderer.whole_arena();
    if (plan.follow) camera = renderer.near(filmed.followed(time_s));
    if (plan.follow && plan.from_above) camera.elevation_deg = -90.0;
    return renderer.draw(filmed.picture(time_s, time_text(time_s)), camera);
  };
  std::size_t pictures = 1;
  if (is_moment) {
    film::write_png(plan.out, draw(from_s));
  } else if (!is_film) {
    film::Image sheet = film::Image::blank(columns * width + (columns - 1) * gap, rows * height + (rows - 1) * gap, 255);
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
