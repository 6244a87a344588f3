// SPDX-License-Identifier: MIT
// Makes the picture of an ecology at a moment, from a recording or a live run.
#pragma once

#include <cmath>
#include <concepts>
#include <span>
#include <trophic/io/tables.hpp>
#include <trophic/pictures/drawing/picture.hpp>
#include <trophic/population/individual.hpp>

namespace trophic::drawing {

/// Place and time of a death.
struct Death {
  double time_s = 0.0;
  double x_m = 0.0;
  double y_m = 0.0;
  bool is_catch = false;
};

/// Time for which a trail and the ring round a death are visible, ecology seconds.
inline constexpr double trail_s = 60.0;
inline constexpr double flash_s = 6.0;

/// Time for which a ring round a death is visible where `pace` ecology seconds pass in a second of the viewer's: that second, but
/// at least `flash_s` and at most 1000 s, as more rings hide the robots.
[[nodiscard]] inline double flash_at(double pace) {
  return std::clamp(pace, flash_s, 1000.0);
}

/// Source of a picture's data at any moment, ecology seconds: `rows_at` has a row for each body, as the last tick left it; rows
/// go back by `trail_s` or to `first_s`, deaths by `flash_s`. If bodies differ, `robot_in(time_s, body)` is its model.
template <class F>
concept Footage = requires(const F& footage, double time_s, std::size_t body) {
  { footage.rows_at(time_s) } -> std::convertible_to<std::span<const io::AgentRow>>;
  { footage.root(time_s, body) } -> std::same_as<Pose>;
  { footage.joint_angles_rad(time_s, body) } -> std::same_as<std::vector<double>>;
  { footage.deaths() } -> std::convertible_to<std::span<const Death>>;
  { footage.robot() } -> std::same_as<const RobotModel&>;
  { footage.arena() } -> std::same_as<const Arena&>;
  { footage.tick_s() } -> std::same_as<double>;
  { footage.first_s() } -> std::same_as<double>;
  { footage.filled_tag() } -> std::same_as<int>;
};

namespace detail {

[[nodiscard]] inline Colour colour(const io::AgentRow& row) {
  return row.active ? species_colour(row.species) : inactive_colour;
}

template <Footage F>
void add_trail(Picture& picture, const F& footage, double time_s, std::size_t body) {
  const double step_s = 2.0 * footage.tick_s();
  const double oldest_s = std::max(footage.first_s(), time_s - trail_s);
  double x_m = picture.robots[body].root.position_m.x();
  double y_m = picture.robots[body].root.position_m.y();
  for (double then_s = std::floor(time_s / step_s - 1e-9) * step_s; then_s >= oldest_s; then_s -= step_s) {
    const io::AgentRow& row = footage.rows_at(then_s)[body];
    const auto strength = static_cast<float>(0.8 * (1.0 - (time_s - then_s) / trail_s));
    picture.lines.push_back({x_m, y_m, row.x_m, row.y_m, colour(row), strength});
    x_m = row.x_m;
    y_m = row.y_m;
  }
}

/// A line from each robot to the one that it hunts or flees.
inline void add_sights(Picture& picture, std::span<const io::AgentRow> rows) {
  for (std::size_t body = 0; body < rows.size(); ++body) {
    if (!rows[body].adversary) continue;
    const auto other = std::ranges::find(rows, *rows[body].adversary, &io::AgentRow::id);
    if (other == rows.end()) continue;
    const Eigen::Vector3d from = picture.robots[body].root.position_m;
    const Eigen::Vector3d to = picture.robots[static_cast<std::size_t>(other - rows.begin())].root.position_m;
    picture.lines.push_back({from.x(), from.y(), to.x(), to.y(), colour(rows[body]), 0.22F});
  }
}

}  // namespace detail

/// The visible parts of a moment other than its robots.
struct Sights {
  std::optional<IndividualId> marked = {};  ///< highlighted individual
  std::optional<double> rows_s =
      {};  ///< who lives where is of this moment, not of the picture's: at its tick a catch's victim is gone
  std::vector<IndividualId> named = {};   ///< whose names are written
  std::vector<std::string> species = {};  ///< what their species are called
  bool has_lines = true;                  ///< trails, and who perceives whom
  double flash_s = drawing::flash_s;
};

/// The picture of a moment.
template <Footage F>
[[nodiscard]] Picture picture_of(const F& footage, double time_s, const Sights& sights, std::string caption) {
  Picture picture;
  picture.caption = std::move(caption);
  const std::span<const io::AgentRow> rows = footage.rows_at(sights.rows_s.value_or(time_s));
  for (std::size_t body = 0; body < rows.size(); ++body) {
    const io::AgentRow& row = rows[body];
    picture.robots.push_back({.root = footage.root(time_s, body),
                              .joint_angles_rad = footage.joint_angles_rad(time_s, body),
                              .colour = detail::colour(row),
                              .filled = row.tag == footage.filled_tag(),
                              .is_marked = sights.marked && row.id == *sights.marked});
    if constexpr (requires { footage.robot_in(time_s, body); }) {
      picture.robots.back().body = footage.robot_in(time_s, body);
    }
    if (sights.has_lines) detail::add_trail(picture, footage, time_s, body);
    if (std::ranges::find(sights.named, row.id) == sights.named.end()) continue;
    const std::string species = row.species < sights.species.size() ? sights.species[row.species] + " " : "";
    picture.names.push_back({picture.robots.back().root.position_m, species + std::to_string(row.id)});
  }
  if (sights.has_lines) detail::add_sights(picture, rows);
  for (const Death& death : footage.deaths()) {
    const double age = (time_s - death.time_s) / sights.flash_s;
    if (age < 0.0 || age >= 1.0) continue;
    const double wide = death.is_catch ? 1.3 + 0.5 * age : 1.2 + 2.2 * age;
    picture.flashes.push_back({death.x_m, death.y_m, ring_radius_m(footage.robot(), footage.arena()) * wide, death.is_catch});
  }
  return picture;
}

/// Names every mark of a picture, and counts who lives at its moment. `species`: their names.
[[nodiscard]] inline std::vector<LegendEntry> legend_of(std::span<const std::string> species, std::span<const io::AgentRow> rows,
                                                        int filled_tag, bool has_lines) {
  using Mark = LegendEntry::Mark;
  std::vector<LegendEntry> legend;
  for (Species i = 0; i < species.size(); ++i) {
    const auto alive = std::ranges::count(rows, i, &io::AgentRow::species);
    legend.push_back({Mark::species, species_colour(i), species[i] + " " + std::to_string(alive)});
  }
  const std::string sign = filled_tag > 0 ? "+" : "";
  legend.push_back({Mark::filled, ink, "tag " + sign + std::to_string(filled_tag)});
  legend.push_back({Mark::hollow, ink, "other tag"});
  legend.push_back({Mark::species, inactive_colour, "not yet active"});
  legend.push_back({Mark::catch_, catch_colour, "caught"});
  legend.push_back({Mark::death, ink, "other death"});
  legend.push_back({Mark::marked, ink, "selected"});
  if (!has_lines) return legend;
  legend.push_back({Mark::trail, ink, "trail"});
  legend.push_back({Mark::sight, ink, "perceives"});
  return legend;
}

/// The pose a part of the way from one to another.
[[nodiscard]] inline Pose between(const Pose& from, const Pose& to, double part) {
  return {from.position_m + part * (to.position_m - from.position_m), from.orientation.slerp(part, to.orientation)};
}

}  // namespace trophic::drawing
