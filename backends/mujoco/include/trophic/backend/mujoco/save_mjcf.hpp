// SPDX-License-Identifier: MIT
// Saves robots in their current poses as an MJCF file for MuJoCo's own programs.
#pragma once

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <initializer_list>
#include <iterator>
#include <span>
#include <sstream>
#include <string>
#include <system_error>
#include <trophic/backend/mujoco/compiled_model.hpp>
#include <trophic/backend/mujoco/robot_states.hpp>
#include <trophic/support/colour.hpp>
#include <trophic/support/new_file.hpp>
#include <utility>
#include <vector>

namespace trophic::backend::mujoco {

/// The colour of robots without a given colour.
inline constexpr Colour any_robot{0.84F, 0.37F, 0.0F};

/// Light, a floor in squares of a metre, colours and a camera, so that robots are visible in MuJoCo's programs. They do not
/// affect the motion.
inline void add_looks(pugi::xml_node root, const Arena& arena, std::span<const Colour> colours) {
  const auto add = [](pugi::xml_node parent, const char* name,
                      std::initializer_list<std::pair<const char*, std::string>> attributes) {
    pugi::xml_node node = parent.append_child(name);
    for (const auto& [key, value] : attributes) node.append_attribute(key).set_value(value.c_str());
  };
  const double half = arena.half_side_m;
  const auto numbers = [](std::initializer_list<double> values) { return numbers_text({values.begin(), values.size()}); };
  add(root, "statistic", {{"center", "0 0 0"}, {"extent", number_text(half)}});
  pugi::xml_node visual = root.append_child("visual");
  add(visual, "headlight", {{"ambient", "0.45 0.45 0.45"}, {"diffuse", "0.2 0.2 0.2"}, {"specular", "0 0 0"}});
  add(visual, "map", {{"znear", "0.002"}});
  add(visual, "global", {{"azimuth", "90"}, {"elevation", "-50"}});
  pugi::xml_node asset = root.child("asset") ? root.child("asset") : root.insert_child_before("asset", root.child("worldbody"));
  add(asset, "texture",
      {{"name", "squares"},
       {"type", "2d"},
       {"builtin", "checker"},
       {"rgb1", "0.93 0.94 0.95"},
       {"rgb2", "0.86 0.88 0.9"},
       {"width", "256"},
       {"height", "256"}});
  add(asset, "material",
      {{"name", "squares"}, {"texture", "squares"}, {"texrepeat", "0.5 0.5"}, {"texuniform", "true"}, {"specular", "0"}});
  pugi::xml_node world = root.child("worldbody");
  for (pugi::xml_node geom : world.children("geom")) {
    const std::string name = geom.attribute("name").value();
    if (name == "floor" || name == "ground") geom.append_attribute("material").set_value("squares");
  }
  std::size_t index = 0;
  for (pugi::xml_node robot : world.children("body")) {
    const Colour core = index < colours.size() ? colours[index] : any_robot;
    ++index;
    for (const pugi::xpath_node& geom : robot.select_nodes(".//geom")) {
      const bool is_root = geom.node().parent() == robot;
      const Colour colour = is_root ? core : limb_colour(core);
      geom.node().append_attribute("rgba").set_value(numbers({colour[0], colour[1], colour[2], 1.0}).c_str());
    }
  }
  add(world, "light",
      {{"directional", "true"},
       {"pos", numbers({0.0, 0.0, half})},
       {"dir", "-0.3 0.5 -1"},
       {"diffuse", "0.35 0.35 0.35"},
       {"specular", "0 0 0"}});
  add(world, "camera", {{"name", "arena"}, {"pos", numbers({0.0, -2.1 * half, 2.3 * half})}, {"xyaxes", "1 0 0 0 0.74 0.67"}});
}

/// One model of all robots, with bodies at their current root poses and the key frame "now" with the whole state. A height
/// field's heights go to the file `path` with the extension ".hfield", which the model names.
inline void save_mjcf(const std::filesystem::path& path, std::span<const RobotModel* const> robots, const Arena& arena,
                      const Physics& physics, BoxDepth box_depth, const RobotStates& states, const Rows& targets_rad,
                      std::span<const Colour> colours) {
  const std::string height_file = std::filesystem::path{path}.replace_extension(".hfield").filename().string();
  std::vector<Pose> poses;
  std::vector<double> positions;
  std::vector<double> velocities;
  std::vector<double> controls;
  const Scene scene{.box_depth = box_depth};
  const CompiledModel compiled{robots, arena, physics, scene, 1};
  for (std::size_t i = 0; i < states.robots(); ++i) {
    poses.push_back(states.root(i));
    std::ranges::copy(states.positions(i), std::back_inserter(positions));
    std::ranges::copy(states.velocities(i), std::back_inserter(velocities));
    std::ranges::copy(targets_rad[i], std::back_inserter(controls));
    controls.resize(controls.size() + compiled.shares()[i].hinges);  // the targets of the brakes
  }

  pugi::xml_document document = write_mjcf(robots, arena, physics, scene, poses, height_file);
  pugi::xml_node root = document.child("mujoco");
  add_looks(root, arena, colours);
  write_capacity(root.append_child("size"), compiled.model());
  auto key = root.append_child("keyframe").append_child("key");
  key.append_attribute("name").set_value("now");
  key.append_attribute("qpos").set_value(numbers_text(positions).c_str());
  key.append_attribute("qvel").set_value(numbers_text(velocities).c_str());
  if (!controls.empty()) key.append_attribute("ctrl").set_value(numbers_text(controls).c_str());

  std::ostringstream text;
  document.save(text, "  ");
  const std::filesystem::path heights = std::filesystem::path{path}.replace_extension(".hfield");
  if (arena.height_field) write_new_file(heights, height_file_content(*arena.height_field));
  try {
    write_new_file(path, text.str());
  } catch (...) {
    std::error_code ignored;
    if (arena.height_field) std::filesystem::remove(heights, ignored);
    throw;
  }
}

}  // namespace trophic::backend::mujoco
