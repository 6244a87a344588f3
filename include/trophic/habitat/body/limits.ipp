// SPDX-License-Identifier: MIT
// Definitions of limits.hpp.
#pragma once

#include <algorithm>
#include <trophic/habitat/body/limits.hpp>
#include <trophic/habitat/hinge_places.hpp>
#include <trophic/habitat/pose.hpp>
#include <trophic/habitat/robot_model.hpp>
#include <trophic/habitat/touch.hpp>

namespace trophic::body {

namespace detail {

/// Boxes that only touch do not overlap: each is shrunk by this share of its extents, some 30 nm.
inline constexpr double touching_share = 1e-6;

[[nodiscard]] inline std::vector<std::vector<PlacedBox>> shrunk_boxes_by_link(const RobotModel& robot) {
  const std::vector<PlacedBox> all = placed_boxes(robot, Pose{}, {});
  std::vector<std::vector<PlacedBox>> by_link(robot.links.size());
  std::size_t next = 0;
  for (std::size_t link = 0; link < robot.links.size(); ++link) {
    for (std::size_t i = 0; i < robot.links[link].boxes.size(); ++i) {
      by_link[link].push_back(all[next++]);
      by_link[link].back().half_edges_m *= 1.0 - touching_share;
    }
  }
  return by_link;
}

[[nodiscard]] inline std::optional<std::string> count_refusal(std::size_t count, std::string_view what, std::size_t fewest,
                                                              std::size_t most) {
  if (count >= fewest && count <= most) return std::nullopt;
  return std::to_string(count) + " " + std::string{what} + ": must be " +
         (count < fewest ? ">= " + std::to_string(fewest) : "<= " + std::to_string(most));
}

}  // namespace detail

TROPHIC_INLINE std::string overlapping_links(const RobotModel& robot) {
  const auto boxes = detail::shrunk_boxes_by_link(robot);
  for (std::size_t b = 1; b < boxes.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      if (robot.links[b].parent == static_cast<int>(a)) continue;
      if (touch(boxes[a], boxes[b])) return robot.links[a].name + " and " + robot.links[b].name;
    }
  }
  return {};
}

TROPHIC_INLINE bool has_sides(const RobotModel& robot) {
  return std::ranges::any_of(hinge_places(robot), [](const HingePlace& hinge) { return hinge.side != Side::middle; });
}

TROPHIC_INLINE std::optional<std::string> refusal(const ModuleTree& tree, const RobotModel& robot, const Limits& limits) {
  if (auto why = detail::count_refusal(tree.modules().size(), "modules", 1, limits.most_modules)) return why;
  if (auto why = detail::count_refusal(robot.hinges.size(), "hinges", limits.fewest_hinges, limits.most_hinges)) return why;
  if (limits.fewest_hinges > 0 && !has_sides(robot)) return "no hinge on the left or right side: must have one to be steerable";
  const std::string links = overlapping_links(robot);
  if (!links.empty()) return "links " + links + ": must not overlap at rest";
  return std::nullopt;
}

}  // namespace trophic::body
