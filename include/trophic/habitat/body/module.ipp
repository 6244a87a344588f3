// SPDX-License-Identifier: MIT
// Definitions of module.hpp.
#pragma once

#include <stdexcept>
#include <trophic/habitat/body/module.hpp>

namespace trophic::body {

TROPHIC_INLINE Eigen::Matrix3i face_rotation(Face face) {
  constexpr std::array<std::array<int, 2>, 4> cos_sin{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
  const auto [c, s] = cos_sin.at(static_cast<std::size_t>(face));
  return (Eigen::Matrix3i() << c, -s, 0, s, c, 0, 0, 0, 1).finished();
}
TROPHIC_INLINE Eigen::Matrix3i roll_rotation(int quarter_turns) {
  constexpr std::array<std::array<int, 2>, 4> cos_sin{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  const auto [c, s] = cos_sin.at(static_cast<std::size_t>(quarter_turns));
  return (Eigen::Matrix3i() << 1, 0, 0, 0, c, -s, 0, s, c).finished();
}

TROPHIC_INLINE std::size_t ModuleTree::attach(std::size_t parent, Face face, ModuleType type, int quarter_turns) {
  if (parent >= modules_.size()) {
    throw std::invalid_argument{"parent = " + std::to_string(parent) + ": must be < " + std::to_string(modules_.size())};
  }
  const auto refuse = [&](const std::string& why) {
    throw std::invalid_argument{join_path(parent == 0 ? "" : path(parent), enum_name(face)) + ": " + why};
  };
  if (type == ModuleType::core) refuse("a robot has only one core");
  const Module& on = modules_[parent];
  if (!has_face(on.type, face)) {
    refuse("a " + std::string{enum_name(on.type)} + " has no " + std::string{enum_name(face)} + " face");
  }
  if (child(parent, face)) refuse("two modules on one face");
  Module added;
  added.type = type;
  added.parent = parent;
  added.face = face;
  added.quarter_turns = ((quarter_turns % 4) + 4) % 4;
  const Eigen::Matrix3i towards = on.orientation * face_rotation(face);
  added.cell = on.cell + towards.col(0);
  added.orientation = towards * roll_rotation(added.quarter_turns);
  for (std::size_t other = 0; other < modules_.size(); ++other) {
    if (modules_[other].cell == added.cell) refuse("overlaps module " + path(other));
  }
  modules_[parent].children.at(static_cast<std::size_t>(face)) = modules_.size();
  modules_.push_back(added);
  return modules_.size() - 1;
}

TROPHIC_INLINE std::string ModuleTree::path(std::size_t module) const {
  const Module& m = modules_.at(module);
  if (!m.parent) return "core";
  const std::string name{enum_name(m.face)};
  return *m.parent == 0 ? name : path(*m.parent) + "." + name;
}

TROPHIC_INLINE std::size_t ModuleTree::distance(std::size_t a, std::size_t b) const {
  std::size_t steps = 0;
  for (; a != b; ++steps) {
    std::size_t& later = a > b ? a : b;
    later = modules_[later].parent.value();
  }
  return steps;
}

}  // namespace trophic::body
