// SPDX-License-Identifier: MIT
// Definitions of descriptors.hpp.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <trophic/habitat/body/descriptors.hpp>
#include <vector>

namespace trophic::body {

namespace detail {

[[nodiscard]] inline double share(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

[[nodiscard]] inline std::size_t attached_faces(const Module& module) {
  return static_cast<std::size_t>(std::ranges::count_if(module.children, [](const auto& child) { return child.has_value(); })) +
         (module.parent ? 1 : 0);
}

/// The share of modules off the plane through the core across `axis` that have a counterpart.
[[nodiscard]] inline double symmetry(const std::vector<Module>& modules, int axis) {
  std::size_t off_plane = 0;
  std::size_t matched = 0;
  for (const Module& module : modules) {
    if (module.cell[axis] == 0) continue;
    ++off_plane;
    Eigen::Vector3i image = module.cell;
    image[axis] = -image[axis];
    matched +=
        std::ranges::any_of(modules, [&](const Module& other) { return other.cell == image && other.type == module.type; });
  }
  return share(matched, off_plane);
}

[[nodiscard]] inline bool joins(const std::vector<Module>& modules, const Module& hinge) {
  const auto& front = hinge.children[static_cast<std::size_t>(Face::front)];
  return hinge.type == ModuleType::hinge && modules[*hinge.parent].type != ModuleType::hinge && front &&
         modules[*front].type != ModuleType::hinge;
}

}  // namespace detail

TROPHIC_INLINE std::size_t count(const ModuleTree& tree, ModuleType type) {
  return static_cast<std::size_t>(std::ranges::count(tree.modules(), type, &Module::type));
}

TROPHIC_INLINE Descriptors descriptors_of(const ModuleTree& tree, std::size_t most_modules) {
  const std::vector<Module>& modules = tree.modules();
  const std::size_t m = modules.size();
  Eigen::Vector3i lowest = Eigen::Vector3i::Zero();
  Eigen::Vector3i highest = Eigen::Vector3i::Zero();
  std::size_t full = 0;
  std::size_t leaves = 0;
  std::size_t passages = 0;
  std::size_t joints = 0;
  for (const Module& module : modules) {
    lowest = lowest.cwiseMin(module.cell);
    highest = highest.cwiseMax(module.cell);
    const std::size_t faces = detail::attached_faces(module);
    full += faces == 4;
    if (!module.parent) continue;
    leaves += faces == 1;
    passages += faces == 2;
    joints += detail::joins(modules, module);
  }
  const Eigen::Vector3d sides = (highest - lowest + Eigen::Vector3i::Ones()).cast<double>();
  const std::size_t most_leaves = m < 6 ? m - 1 : 2 * ((m - 6) / 3) + (m - 6) % 3 + 4;
  return {.size = detail::share(m, most_modules),
          .proportion = std::min(sides.x(), sides.y()) / std::max(sides.x(), sides.y()),
          .coverage = static_cast<double>(m) / sides.prod(),
          .branching = m < 5 ? 0.0 : detail::share(full, (m - 2) / 3),
          .limbs = detail::share(leaves, most_leaves),
          .length_of_limbs = m < 3 ? 0.0 : detail::share(passages, m - 2),
          .symmetry = std::max(detail::symmetry(modules, 0), detail::symmetry(modules, 1)),
          .joints = detail::share(joints, (m - 1) / 2)};
}

}  // namespace trophic::body
