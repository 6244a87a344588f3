// SPDX-License-Identifier: MIT
// Saves robots where they stand as an MJCF file for MuJoCo's own programs.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <trophic/backend/mujoco/compiled_model.hpp>
#include <trophic/backend/mujoco/robot_states.hpp>
#include <vector>

namespace trophic::backend::mujoco {

/// Throws std::runtime_error naming the file if not every byte reached it.
inline void write_file(const std::filesystem::path& path, const std::string& content) {
  std::ofstream file{path, std::ios::binary};
  file << content << std::flush;
  if (!file) throw std::runtime_error{path.string() + ": cannot be written"};
}

/// One model of all robots, bodies at their present root poses, and the key frame "now" with the whole state. A height field's
/// heights go to the file `path` with the extension ".hfield", which the model names.
inline void save_mjcf(const std::filesystem::path& path, const RobotModel& robot, const Arena& arena, const Physics& physics,
                      BoxDepth box_depth, const RobotStates& states, std::span<const double> targets_rad) {
  const std::string height_file = std::filesystem::path{path}.replace_extension(".hfield").filename().string();
  std::vector<Pose> poses;
  std::vector<double> positions;
  std::vector<double> velocities;
  std::vector<double> controls;
  const Scene scene{.box_depth = box_depth};
  const CompiledModel compiled{robot, arena, physics, scene, states.robots(), 1};
  const Layout& layout = compiled.layout();
  for (std::size_t i = 0; i < states.robots(); ++i) {
    poses.push_back(states.root(i));
    std::ranges::copy(states.positions(i), std::back_inserter(positions));
    std::ranges::copy(states.velocities(i), std::back_inserter(velocities));
    std::ranges::copy(targets_rad.subspan(i * layout.hinges, layout.hinges), std::back_inserter(controls));
    controls.resize((i + 1) * layout.controls);
  }

  pugi::xml_document document = write_mjcf(robot, arena, physics, scene, poses, height_file);
  pugi::xml_node root = document.child("mujoco");
  auto size = root.append_child("size");
  size.append_attribute("njmax").set_value(compiled.model().njmax);
  size.append_attribute("nconmax").set_value(compiled.model().nconmax);
  size.append_attribute("nstack").set_value(compiled.model().nstack);
  auto key = root.append_child("keyframe").append_child("key");
  key.append_attribute("name").set_value("now");
  key.append_attribute("qpos").set_value(numbers_text(positions).c_str());
  key.append_attribute("qvel").set_value(numbers_text(velocities).c_str());
  if (!controls.empty()) key.append_attribute("ctrl").set_value(numbers_text(controls).c_str());

  std::ostringstream text;
  document.save(text, "  ");
  if (arena.height_field)
    write_file(std::filesystem::path{path}.replace_extension(".hfield"), height_file_content(*arena.height_field));
  write_file(path, text.str());
}

}  // namespace trophic::backend::mujoco
