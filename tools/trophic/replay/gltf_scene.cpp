// SPDX-License-Identifier: MIT
// Definitions of gltf_scene.hpp.
#include <tools/trophic/replay/gltf_scene.hpp>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <tools/recording/species_colour.hpp>

namespace trophic::command::replay {

GltfScene::GltfScene(const RecordedRun& run, double from_s, double to_s, std::optional<IndividualId> only)
    : recording_{run.recording},
      first_{recording_.frame_at(from_s)},
      last_{recording_.frame_at(to_s)},
      agents_{run, recording_.time_s(first_), recording_.time_s(last_), run.recording.head().times.tick_s},
      food_{run} {
  const auto& head = recording_.head();
  const double bytes = 4.0 * static_cast<double>((last_ - first_ + 1) * (only ? 1 : head.robots) * (7 + 4 * head.joints));
  if (!(bytes <= most_bytes)) {
    throw std::invalid_argument{"--from, --to: " + std::to_string(last_ - first_ + 1) + " frames take " +
                                std::to_string(static_cast<long>(bytes / 1e6)) +
                                " MB: must be <= 1000; choose a shorter time, or one robot with --follow"};
  }
  file_.describe({{"fingerprint", head.fingerprint},
                  {"seed", head.seed},
                  {"rule_table", head.rule_table},
                  {"from_s", recording_.time_s(first_)},
                  {"to_s", recording_.time_s(last_)}});
  for (std::size_t i = 0; i < head.species.size(); ++i) {
    const Colour colour = species_colour(i);
    cores_.push_back(file_.add_box(head.species[i], file_.add_material(head.species[i], colour)));
    limbs_.push_back(
        file_.add_box(head.species[i] + " limb", file_.add_material(head.species[i] + " limb", limb_colour(colour))));
  }
  add_arena(head.arena);
  for (std::size_t body = 0; body < head.robots; ++body) add_occupants(body, only);
  if (only && individuals_ == 0) {
    throw std::invalid_argument{"--follow " + std::to_string(*only) + ": no individual with this id lives between " +
                                number_text(from_s) + " and " + number_text(to_s) + " s"};
  }
}

float GltfScene::since_first(std::size_t frame) const {
  return static_cast<float>(recording_.time_s(frame) - recording_.time_s(first_));
}

void GltfScene::add_arena(const Arena& arena) {
  const double half = arena.half_side_m;
  const std::size_t node = file_.add_node(GltfFile::upright(), "arena", Eigen::Vector3d::Zero(), Eigen::Quaterniond::Identity());
  const std::size_t floor = file_.add_material("floor", {0.93F, 0.94F, 0.95F});
  const std::size_t wall = file_.add_material("wall", {0.72F, 0.76F, 0.8F});
  for (const Obstacle& one : arena.obstacles) add_obstacle(node, wall, one);
  const std::size_t edge = arena.zones.empty() ? 0 : file_.add_material("zone", film::zone_colour);
  for (const Zone& one : arena.zones) add_zone(node, edge, one, 0.004 * half);
  const auto put = [&](std::size_t mesh, const Eigen::Vector3d& at_m, const Eigen::Vector3d& half_m) {
    file_.add_shape(node, mesh, at_m, Eigen::Quaterniond::Identity(), half_m);
  };
  add_food(node);
  if (arena.height_field) return add_slopes(node, floor, *arena.height_field);
  put(file_.add_box("floor", floor), {0.0, 0.0, -0.01}, {half, half, 0.01});
  const std::size_t box = file_.add_box("wall", wall);
  const double thick_m = 0.006 * half;
  const double high_m = 0.0175 * half;
  for (const double side : {-1.0, 1.0}) {
    put(box, {side * (half + thick_m), 0.0, high_m}, {thick_m, half + 2.0 * thick_m, high_m});
    put(box, {0.0, side * (half + thick_m), high_m}, {half + 2.0 * thick_m, thick_m, high_m});
  }
}

/// A plate in each cell for each food, side by side, whose area follows the food in it.
void GltfScene::add_food(std::size_t parent) {
  constexpr std::size_t moments = 64;
  std::vector<float> times_s;
  std::vector<std::vector<film::FoodTile>> food;
  for (std::size_t frame = first_; frame <= last_; frame += 1 + (last_ - first_) / moments) {
    times_s.push_back(since_first(frame));
    food.push_back(food_.at(recording_.time_s(frame)));
  }
  if (food.front().empty()) return;
  const std::size_t times = file_.add_times(times_s);
  const std::size_t count = food_.names().size();
  for (std::size_t kind = 0; kind < count; ++kind) {
    const std::string& name = food_.names()[kind];
    const std::size_t plate = file_.add_box(name, file_.add_material(name, food_colour(kind)));
    const double part = 1.0 / static_cast<double>(count);
    const double aside = part * static_cast<double>(2 * kind + 1) - 1.0;  // of half a cell
    for (std::size_t tile = 0; tile < food.front().size(); ++tile) {
      std::vector<float> scales;
      for (const auto& tiles : food) {
        const auto half_m = static_cast<float>(tiles[tile].half_side_m * std::sqrt(std::max(tiles[tile].foods[kind], 1e-4F)));
        scales.insert(scales.end(), {static_cast<float>(part) * half_m, half_m, 0.01F});
      }
      const film::FoodTile& at = food.front()[tile];
      const std::size_t node = file_.add_shape(parent, plate, {at.x_m + aside * at.half_side_m, at.y_m, -0.008},
                                               Eigen::Quaterniond::Identity(), {scales[0], scales[1], scales[2]});
      if (times_s.size() > 1) file_.move(node, "scale", times, scales);
    }
  }
}

/// A prism of 24 sides for each round end, and a box between them.
void GltfScene::add_obstacle(std::size_t parent, std::size_t material, const Obstacle& one) {
  constexpr std::uint32_t sides = 24;
  std::vector<float> places;
  std::vector<float> normals;
  std::vector<std::uint32_t> corners;
  const auto add = [&](double x, double y, double z, double nx, double ny, double nz) {
    for (const double number : {x, y, z}) places.push_back(static_cast<float>(number));
    for (const double number : {nx, ny, nz}) normals.push_back(static_cast<float>(number));
  };
  for (std::uint32_t side = 0; side <= sides; ++side) {
    const double angle_rad = 2.0 * std::numbers::pi * side / sides;
    const double x = std::cos(angle_rad);
    const double y = std::sin(angle_rad);
    add(x, y, 0.0, x, y, 0.0);
    add(x, y, 1.0, x, y, 0.0);
    add(x, y, 1.0, 0.0, 0.0, 1.0);
  }
  const auto top = static_cast<std::uint32_t>(places.size() / 3);
  add(0.0, 0.0, 1.0, 0.0, 0.0, 1.0);
  for (std::uint32_t at = 0; at < 3 * sides; at += 3) {
    for (const std::uint32_t corner : {at, at + 3, at + 1, at + 1, at + 3, at + 4, top, at + 2, at + 5})
      corners.push_back(corner);
  }
  const std::size_t prism = file_.add_surface("pillar", material, places, normals, corners);
  const Eigen::Vector3d size_m{one.radius_m, one.radius_m, one.height_m};
  file_.add_shape(parent, prism, {one.x_m, one.y_m, 0.0}, Eigen::Quaterniond::Identity(), size_m);
  if (one.is_pillar()) return;
  file_.add_shape(parent, prism, {one.to_x_m, one.to_y_m, 0.0}, Eigen::Quaterniond::Identity(), size_m);
  const Eigen::AngleAxisd along{one.turn_rad(), Eigen::Vector3d::UnitZ()};
  const Eigen::Vector3d middle_m{one.middle_x_m(), one.middle_y_m(), 0.5 * one.height_m};
  file_.add_shape(parent, file_.add_box("side", material), middle_m, Eigen::Quaterniond{along},
                  {0.5 * one.length_m(), one.radius_m, 0.5 * one.height_m});
}

/// A flat ring, a little above the floor and its food.
void GltfScene::add_zone(std::size_t parent, std::size_t material, const Zone& one, double wide_m) {
  constexpr std::uint32_t sides = 48;
  std::vector<float> places;
  std::vector<float> normals;
  std::vector<std::uint32_t> corners;
  for (std::uint32_t side = 0; side <= sides; ++side) {
    const double angle_rad = 2.0 * std::numbers::pi * side / sides;
    for (const double radius_m : {one.radius_m - wide_m, one.radius_m}) {
      for (const double place : {radius_m * std::cos(angle_rad), radius_m * std::sin(angle_rad), 0.0})
        places.push_back(static_cast<float>(place));
      for (const float normal : {0.0F, 0.0F, 1.0F}) normals.push_back(normal);
    }
    if (side == sides) continue;
    for (const std::uint32_t corner : {0U, 1U, 3U, 0U, 3U, 2U}) corners.push_back(2 * side + corner);
  }
  file_.add_shape(parent, file_.add_surface(one.name, material, places, normals, corners), {one.x_m, one.y_m, 0.004},
                  Eigen::Quaterniond::Identity(), Eigen::Vector3d::Ones());
}

void GltfScene::add_slopes(std::size_t parent, std::size_t material, const HeightField& field) {
  const double cell_m = 2.0 * field.half_extent_m / static_cast<double>(field.nodes - 1);
  const auto height = [&](std::size_t ix, std::size_t iy) { return field.height_m[iy * field.nodes + ix]; };
  const auto slope = [&](std::size_t low, std::size_t high, double rise_m) {
    return -rise_m / (cell_m * static_cast<double>(high - low));
  };
  std::vector<float> places;
  std::vector<float> normals;
  std::vector<std::uint32_t> corners;
  const auto index = [&](std::size_t ix, std::size_t iy) { return static_cast<std::uint32_t>(iy * field.nodes + ix); };
  for (std::size_t iy = 0; iy < field.nodes; ++iy) {
    for (std::size_t ix = 0; ix < field.nodes; ++ix) {
      const std::size_t west = ix == 0 ? 0 : ix - 1;
      const std::size_t east = std::min(ix + 1, field.nodes - 1);
      const std::size_t south = iy == 0 ? 0 : iy - 1;
      const std::size_t north = std::min(iy + 1, field.nodes - 1);
      const Eigen::Vector3d normal = Eigen::Vector3d{slope(west, east, height(east, iy) - height(west, iy)),
                                                     slope(south, north, height(ix, north) - height(ix, south)), 1.0}
                                         .normalized();
      for (const double value : {static_cast<double>(ix) * cell_m - field.half_extent_m,
                                 static_cast<double>(iy) * cell_m - field.half_extent_m, height(ix, iy)}) {
        places.push_back(static_cast<float>(value));
      }
      for (int i = 0; i < 3; ++i) normals.push_back(static_cast<float>(normal[i]));
      if (ix + 1 == field.nodes || iy + 1 == field.nodes) continue;
      for (const std::uint32_t corner :
           {index(ix, iy), index(ix + 1, iy), index(ix + 1, iy + 1), index(ix, iy), index(ix + 1, iy + 1), index(ix, iy + 1)}) {
        corners.push_back(corner);
      }
    }
  }
  file_.add_shape(parent, file_.add_surface("ground", material, places, normals, corners), Eigen::Vector3d::Zero(),
                  Eigen::Quaterniond::Identity(), Eigen::Vector3d::Ones());
}

void GltfScene::add_occupants(std::size_t body, std::optional<IndividualId> only) {
  std::size_t from = first_;
  const auto row_at = [&](std::size_t frame) { return agents_.find(recording_.time_s(frame), body); };
  while (from <= last_) {
    const io::AgentRow* row = row_at(from);
    std::size_t next = from + 1;
    const auto stays = [&](const io::AgentRow* then) {
      return row == nullptr ? then == nullptr : then != nullptr && then->id == row->id;
    };
    while (next <= last_ && stays(row_at(next))) ++next;
    // The frame of a death is the last one of the dead and the first one of its successor in the body.
    if (row != nullptr && (!only || row->id == *only)) add_individual(body, *row, from, next);
    from = next;
  }
}

void GltfScene::add_individual(std::size_t body, const io::AgentRow& row, std::size_t from, std::size_t next) {
  ++individuals_;
  // A newborn's own body is set down after the frame of its birth.
  if (from < std::min(next, last_) && recording_.is_set_down(from + 1, body)) ++from;
  const std::size_t to = std::min(next, last_);
  const RobotModel& robot = recording_.robot(from, body);
  const Pose start = agents_.root(recording_, from, row);
  const std::size_t root =
      file_.add_node(GltfFile::upright(), "robot " + std::to_string(row.id), start.position_m, start.orientation);
  file_.describe(root, {{"id", row.id}, {"species", recording_.head().species.at(row.species)}, {"body", body}});
  std::vector<std::size_t> links{root};
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const Link& link = robot.links[i];
    if (i > 0) {
      const std::string& name = robot.hinges[i - 1].name;
      links.push_back(file_.add_node(links[static_cast<std::size_t>(link.parent)], name, link.offset_m, turned(i, from, body)));
    }
    for (const Box& box : link.boxes) {
      file_.add_shape(links[i], (i == 0 ? cores_ : limbs_)[row.species], box.centre_m, box.orientation, box.half_extents_m);
    }
  }
  if (to > from) add_motion(row, links, from, to);
  add_lifetime(root, from, next);
}

Eigen::Quaterniond GltfScene::turned(std::size_t link, std::size_t frame, std::size_t body) const {
  const RobotModel& robot = recording_.robot(frame, body);
  if (recording_.head().joints == 0) return robot.links[link].rotation;
  const double angle_rad = recording_.joint_angle_rad(frame, body, link - 1);
  return (robot.links[link].rotation * Eigen::AngleAxisd{angle_rad, robot.hinges[link - 1].axis}).normalized();
}

void GltfScene::add_motion(const io::AgentRow& row, const std::vector<std::size_t>& links, std::size_t from, std::size_t to) {
  const std::size_t times = times_between(from, to);
  const std::size_t body = row.body;
  std::vector<float> times_s;  // of places: a robot leaves over the edge of a torus, then enters on the other side
  std::vector<float> places;
  std::vector<float> turns;
  Eigen::Quaterniond before = recording_.root(from, body).orientation;
  const double side_m = 2.0 * recording_.head().arena.half_side_m;
  const auto add_place = [&](float time_s, const Eigen::Vector3d& at_m) {
    times_s.push_back(time_s);
    for (int i = 0; i < 3; ++i) places.push_back(static_cast<float>(at_m[i]));
  };
  Eigen::Vector3d last_m = agents_.root(recording_, from, row).position_m;
  for (std::size_t frame = from; frame <= to; ++frame) {
    const Pose pose = agents_.root(recording_, frame, row);
    const Eigen::Vector3d step_m = pose.position_m - last_m;
    const Eigen::Vector3d over_m{side_m * std::round(step_m.x() / side_m), side_m * std::round(step_m.y() / side_m), 0.0};
    if (!over_m.isZero()) {  // between frames, so that no moment of a frame falls into the jump
      const float time_s = std::lerp(since_first(frame - 1), since_first(frame), 0.63F);
      const Eigen::Vector3d beyond_m = last_m + 0.63 * (step_m - over_m);
      add_place(time_s, beyond_m);
      add_place(std::nextafter(time_s, since_first(frame)), beyond_m + over_m);
    }
    add_place(since_first(frame), pose.position_m);
    last_m = pose.position_m;
    add_turn(turns, pose.orientation, before);
  }
  file_.move(links[0], "translation", times_s.size() == to - from + 1 ? times : file_.add_times(times_s), places);
  file_.move(links[0], "rotation", times, turns);
  if (recording_.head().joints == 0) return;
  for (std::size_t link = 1; link < links.size(); ++link) {
    turns.clear();
    before = turned(link, from, body);
    for (std::size_t frame = from; frame <= to; ++frame) add_turn(turns, turned(link, frame, body), before);
    file_.move(links[link], "rotation", times, turns);
  }
}

void GltfScene::add_turn(std::vector<float>& turns, const Eigen::Quaterniond& turn, Eigen::Quaterniond& before) {
  const double sign = before.dot(turn) < 0.0 ? -1.0 : 1.0;
  before = Eigen::Quaterniond{sign * turn.coeffs()};
  for (int i = 0; i < 4; ++i) turns.push_back(static_cast<float>(before.coeffs()[i]));
}

void GltfScene::add_lifetime(std::size_t node, std::size_t from, std::size_t next) {
  std::vector<float> times_s;
  std::vector<float> scales;
  const auto add = [&](std::size_t frame, float scale) {
    times_s.push_back(since_first(frame));
    scales.insert(scales.end(), 3, scale);
  };
  if (from > first_) add(first_, 0.0F);
  add(from, 1.0F);
  if (next <= last_) add(next, 0.0F);
  if (times_s.size() > 1) file_.move(node, "scale", file_.add_times(times_s), scales, true);
}

std::size_t GltfScene::times_between(std::size_t from, std::size_t to) {
  const auto [found, is_new] = times_.try_emplace({from, to}, 0);
  if (is_new) {
    std::vector<float> times_s;
    for (std::size_t frame = from; frame <= to; ++frame) times_s.push_back(since_first(frame));
    found->second = file_.add_times(times_s);
  }
  return found->second;
}

}  // namespace trophic::command::replay
