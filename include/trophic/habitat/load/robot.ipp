// SPDX-License-Identifier: MIT
// Definitions of robot.hpp.
#pragma once

#include <cmath>
#include <stdexcept>
#include <trophic/habitat/body/module.hpp>
#include <trophic/habitat/load/robot.hpp>
#include <trophic/habitat/load/toml_table.hpp>

namespace trophic {

namespace detail {

inline void read_modules(const TomlTable& table, body::ModuleTree& tree, std::size_t parent) {
  for (const body::Face face : body::all_faces) {
    const std::string name{enum_name(face)};
    if (!table.has(name)) continue;
    const TomlTable child = table.table(name);
    const std::string type = child.text("module");
    if (type != "hinge" && type != "brick") child.fail("module", " = \"" + type + "\": must be \"hinge\" or \"brick\"");
    double rotation_deg = 0.0;
    if (child.has("rotation_deg")) rotation_deg = child.number("rotation_deg", between(-360.0, 360.0));
    if (std::fmod(rotation_deg, 90.0) != 0.0) {
      child.fail("rotation_deg", " = " + number_text(rotation_deg) + ": must be a multiple of 90");
    }
    std::size_t added = 0;
    try {
      added = tree.attach(parent, face, type == "hinge" ? body::ModuleType::hinge : body::ModuleType::brick,
                          static_cast<int>(rotation_deg / 90.0));
    } catch (const std::invalid_argument& error) {
      child.fail("module", " = \"" + type + "\": " + error.what());
    }
    read_modules(child, tree, added);
    child.no_other_keys();
  }
}

}  // namespace detail

TROPHIC_INLINE body::Design load_design(std::string_view name_or_path, std::string_view installed) {
  const auto file = detail::TomlTable::read(find_model(ModelKind::robot, name_or_path, installed));
  body::Design design;
  design.name = file.text("name");
  if (file.has("gait")) design.gait = file.text("gait");
  file.read_fields(design);
  if (file.has("root_density_kg_m3")) design.root_density_kg_m3 = file.number("root_density_kg_m3", above(0.0));
  if (file.has("servo")) {
    const auto servo = file.table("servo");
    if (servo.has("position_gain")) design.servo.position_gain = servo.number("position_gain", above(0.0));
    if (servo.has("velocity_gain")) design.servo.velocity_gain = servo.number("velocity_gain", at_least(0.0));
    if (servo.has("target_limit_rad")) design.servo.target_limit_rad = servo.number("target_limit_rad", above(0.0));
    servo.no_other_keys();
  }
  const auto core = file.table("core");
  detail::read_modules(core, design.modules, 0);
  core.no_other_keys();
  file.no_other_keys();
  return design;
}

TROPHIC_INLINE RobotModel load_robot(std::string_view name_or_path, std::string_view installed) {
  return body::build(load_design(name_or_path, installed));
}

}  // namespace trophic
