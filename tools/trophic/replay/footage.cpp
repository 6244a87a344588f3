// SPDX-License-Identifier: MIT
// Definitions of footage.hpp.
#include <tools/trophic/replay/footage.hpp>

#ifdef TROPHIC_WITH_FILM
#include <cmath>
#include <memory>
#include <set>
#include <span>
#include <stdexcept>
#include <tools/reading/csv_reader.hpp>
#include <trophic/params/params.hpp>

namespace trophic::command::replay {

namespace {

constexpr double trail_s = 60.0;  ///< length of a trail, ecology seconds

Colour colour(const io::AgentRow& row) {
  return row.active ? species_colour(row.species) : inactive_colour;
}

/// A line from each robot to the one that it hunts or flees.
void add_sights(film::Picture& picture, std::span<const io::AgentRow> rows) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!rows[i].adversary) continue;
    const auto other = std::ranges::find(rows, *rows[i].adversary, &io::AgentRow::id);
    if (other == rows.end()) continue;
    const Eigen::Vector3d from = picture.robots[i].root.position_m;
    const Eigen::Vector3d to = picture.robots[static_cast<std::size_t>(other - rows.begin())].root.position_m;
    picture.lines.push_back({from.x(), from.y(), to.x(), to.y(), colour(rows[i]), 0.5F, true});
  }
}

}  // namespace

Footage::Footage(const RecordedRun& run, double from_s, double to_s, double flash_s)
    : recording_{run.recording},
      agents_{run, from_s, to_s, trail_s},
      food_{run},
      from_s_{from_s},
      to_s_{to_s},
      flash_s_{flash_s},
      tags_{run.manifest.at("tags").get<std::vector<int>>()},
      rules_(run.manifest.value("rules", Json::object())),
      species_{run.manifest.at("species").get<std::vector<std::string>>()} {
  analysis::CsvReader events{run.folder / "events.csv", {"time_s", "event", "x_m", "y_m", "cause", "id"}};
  while (events.next()) {
    const auto time_s = events.get<double>(0);
    if (events.text(1) != "death" || time_s < from_s_ - flash_s_ || time_s > to_s_) continue;
    deaths_.push_back(
        {time_s, events.get<double>(2), events.get<double>(3), events.text(4) == "caught", events.get<IndividualId>(5)});
  }
  const double step_s = std::max(head().times.tick_s, (to_s - from_s) / 200.0);  // as many points as one sees
  bool changes = false;
  for (Species i = 0; i < species_.size(); ++i) curves_.push_back({species_colour(i), {}});
  for (double then_s = from_s; then_s <= to_s; then_s += step_s) {
    const std::span<const io::AgentRow> rows = agents_.at(then_s);
    changes |= rows.size() != agents_.at(from_s).size();
    for (Species i = 0; i < species_.size(); ++i) {
      const auto living = std::ranges::count(rows, i, &io::AgentRow::species);
      curves_[i].points.push_back({(then_s - from_s) / (to_s - from_s), static_cast<double>(living)});
      most_ = std::max(most_, curves_[i].points.back()[1]);
    }
  }
  if (!changes) curves_.clear();
}

film::Picture Footage::picture(double time_s, const Sights& sights) const {
  film::Picture picture;
  picture.food = food_.at(time_s);
  const std::span<const io::AgentRow> rows = agents_.at(sights.rows_s.value_or(time_s));
  for (const io::AgentRow& row : rows) {
    picture.robots.push_back(look(time_s, row));
    picture.robots.back().is_marked = row.id == sights.marked;
    if (sights.has_lines) add_trail(picture, time_s, row);
    if (std::ranges::find(sights.named, row.id) == sights.named.end()) continue;
    const film::RobotLook& named = picture.robots.back();
    picture.names.push_back({picture.robots.size() - 1, species_.at(row.species) + " " + std::to_string(row.id)});
    if (row.id != sights.hunter || !sights.reach_m) continue;
    picture.circles.push_back({named.root.position_m.x(), named.root.position_m.y(), *sights.reach_m, ink});
  }
  if (sights.has_lines) add_sights(picture, rows);
  for (const Death& death : deaths_) {
    const double age = (time_s - death.time_s) / flash_s_;
    if (age < 0.0 || age >= 1.0 || (sights.victim && death.id != *sights.victim)) continue;
    const double wide = death.is_catch ? 1.3 + 0.5 * age : 1.2 + 2.2 * age;
    picture.flashes.push_back({death.x_m, death.y_m, wide, death.is_catch});
  }
  return picture;
}

film::RobotLook Footage::look(double time_s, const io::AgentRow& row) const {
  const auto [before, after, part] = around(time_s, row.body);
  film::RobotLook look{.root = root(time_s, row.body, &row),
                       .joint_angles_rad = {},
                       .colour = colour(row),
                       .filled = tags_.size() > 1 && row.tag == std::ranges::max(tags_)};
  const bool differ = head().bodies_differ;
  const std::size_t joints = differ ? recording_.robot(before, row.body).hinges.size() : head().joints;
  for (std::size_t joint = 0; joint < joints; ++joint) {
    const double a = recording_.joint_angle_rad(before, row.body, joint);
    look.joint_angles_rad.push_back(a + part * (recording_.joint_angle_rad(after, row.body, joint) - a));
  }
  if (differ) look.body = {std::shared_ptr<void>{}, &recording_.robot(before, row.body)};  // the recording owns it
  return look;
}

void Footage::add_trail(film::Picture& picture, double time_s, const io::AgentRow& now) const {
  const double step_s = 2.0 * head().times.tick_s;
  const double oldest_s = std::max(head().first_time_s, time_s - trail_s);
  Eigen::Vector3d from = picture.robots.back().root.position_m;
  for (double then_s = std::floor(time_s / step_s - 1e-9) * step_s; then_s >= oldest_s; then_s -= step_s) {
    const io::AgentRow* row = agents_.find(then_s, now.body);
    if (row == nullptr) return;
    // Up to where its individual was born in a place of its own, or came over the edge of a torus.
    const double most_m = row->id == now.id ? head().arena.half_side_m : head().robot.bounding_radius_m;
    if (std::hypot(row->x_m - from.x(), row->y_m - from.y()) > most_m) return;
    const auto strength = static_cast<float>(0.8 * (1.0 - (time_s - then_s) / trail_s));
    picture.lines.push_back({from.x(), from.y(), row->x_m, row->y_m, colour(*row), strength});
    from = {row->x_m, row->y_m, 0.0};
  }
}

void Footage::add_curves(film::Picture& picture, double time_s) const {
  picture.curves = curves_;
  picture.most = most_;
  const double now = (time_s - from_s_) / (to_s_ - from_s_);
  for (film::Curve& curve : picture.curves) std::erase_if(curve.points, [&](const auto& point) { return point[0] > now; });
}

std::vector<film::LegendEntry> Footage::legend(double time_s, const Sights& sights) const {
  using Mark = film::LegendEntry::Mark;
  const std::span<const io::AgentRow> rows = agents_.at(sights.rows_s.value_or(time_s));
  std::vector<film::LegendEntry> legend;
  for (Species i = 0; i < species_.size(); ++i) {
    const auto alive = std::ranges::count(rows, i, &io::AgentRow::species);
    legend.push_back({Mark::species, species_colour(i), species_[i] + " " + std::to_string(alive)});
  }
  const auto tag = [](int value) { return "tag " + std::string{value > 0 ? "+" : ""} + std::to_string(value); };
  const auto fills = [&](std::initializer_list<const char*> slots) {
    return std::ranges::any_of(slots, [&](const char* slot) { return rules_.contains(slot); });
  };
  if (tags_.size() > 1) {
    legend.push_back({Mark::filled, ink, tag(std::ranges::max(tags_))});
    legend.push_back({Mark::hollow, ink, tags_.size() == 2 ? tag(std::ranges::min(tags_)) : "other tags"});
  }
  if (fills({"activation"})) legend.push_back({Mark::species, inactive_colour, "not yet active"});
  if (fills({"capture"})) legend.push_back({Mark::catch_, film::catch_colour, "caught"});
  if (fills({"starvation", "metabolism", "senescence", "minimum_predators"})) legend.push_back({Mark::death, ink, "other death"});
  if (sights.reach_m) legend.push_back({Mark::reach, ink, "reach of " + number_text(*sights.reach_m) + " m"});
  for (std::size_t food = 0; food < food_.names().size(); ++food)
    legend.push_back({Mark::food, food_colour(food), food_.names()[food]});
  std::set<std::string> zones;
  for (const Zone& zone : head().arena.zones) zones.insert(zone.name);
  for (const std::string& name : zones) legend.push_back({Mark::zone, film::zone_colour, name});
  if (sights.marked) legend.push_back({Mark::marked, ink, "selected"});
  if (!sights.has_lines) return legend;
  legend.push_back({Mark::trail, ink, "path of " + number_text(trail_s) + " s"});
  legend.push_back({Mark::sight, ink, "perceives"});
  return legend;
}

Pose Footage::root(double time_s, std::size_t body, const io::AgentRow* row) const {
  const auto [before, after, part] = around(time_s, body);
  const auto pose = [&](std::size_t frame) {
    return row == nullptr ? recording_.root(frame, body) : agents_.root(recording_, frame, *row);
  };
  const Pose from = pose(before);
  const Pose to = pose(after);
  if ((to.position_m - from.position_m).norm() > head().arena.half_side_m) return from;  // over the edge of a torus
  return {from.position_m + part * (to.position_m - from.position_m), from.orientation.slerp(part, to.orientation)};
}

std::size_t Footage::body_of(IndividualId id) const {
  const double tick_s = head().times.tick_s;
  const auto ticks = static_cast<std::size_t>(std::ceil((to_s_ - from_s_) / tick_s - 1e-9));
  for (std::size_t tick = 0; tick <= ticks; ++tick) {
    const auto rows = agents_.at(std::min(to_s_, from_s_ + static_cast<double>(tick) * tick_s));
    const auto found = std::ranges::find(rows, id, &io::AgentRow::id);
    if (found != rows.end()) return found->body;
  }
  throw std::invalid_argument{"--follow " + std::to_string(id) + ": no individual with this id lives between " +
                              number_text(from_s_) + " and " + number_text(to_s_) + " s"};
}

std::tuple<std::size_t, std::size_t, double> Footage::around(double time_s, std::size_t body) const {
  const std::size_t before = recording_.frame_at(time_s);
  const std::size_t next = std::min(before + 1, recording_.frames() - 1);
  const std::size_t after = recording_.is_set_down(next, body) ? before : next;
  const double gap_s = recording_.time_s(after) - recording_.time_s(before);
  return {before, after, gap_s > 0.0 ? (time_s - recording_.time_s(before)) / gap_s : 0.0};
}

}  // namespace trophic::command::replay
#endif
