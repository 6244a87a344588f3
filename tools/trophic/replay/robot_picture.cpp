// SPDX-License-Identifier: MIT
// Definitions of robot_picture.hpp.
#include <tools/trophic/replay/robot_picture.hpp>

#ifdef TROPHIC_WITH_FILM
#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <tools/film/camera.hpp>
#include <tools/film/image.hpp>
#include <tools/film/picture.hpp>
#include <tools/film/renderer.hpp>
#include <trophic/habitat/arena.hpp>
#include <trophic/habitat/link_frames.hpp>
#include <trophic/habitat/load/robot.hpp>
#include <trophic/observe/progress.hpp>

namespace trophic::command::replay {

namespace {

/// The smallest box with the axes of the world that has all of a robot, its root in the origin and all angles 0.
Eigen::AlignedBox3d bounds_of(const RobotModel& robot) {
  Eigen::AlignedBox3d bounds;
  const std::vector<Eigen::Isometry3d> frames = link_frames(robot, {}, {});
  for (std::size_t i = 0; i < frames.size(); ++i) {
    for (const Box& box : robot.links[i].boxes) {
      const Eigen::Isometry3d frame = frames[i] * Eigen::Translation3d{box.centre_m} * box.orientation;
      const Eigen::Vector3d half = frame.linear().cwiseAbs() * box.half_extents_m;
      bounds.extend(Eigen::Vector3d{frame.translation() - half});
      bounds.extend(Eigen::Vector3d{frame.translation() + half});
    }
  }
  return bounds;
}

std::string counted(std::size_t count, const std::string& thing) {
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

std::string title_of(const RobotModel& robot) {
  const double mass_kg = std::accumulate(robot.links.begin(), robot.links.end(), 0.0,
                                         [](double sum, const Link& link) { return sum + link.mass_kg; });
  return robot.name + ": " + counted(robot.links.size(), "link") + ", " + counted(robot.hinges.size(), "hinge") + ", " +
         observe::short_text(mass_kg) + " kg";
}

}  // namespace

void draw_robot(const RobotPicture& plan) {
  const RobotModel robot = load_robot(plan.robot);
  const Eigen::AlignedBox3d bounds = bounds_of(robot);
  Arena floor;
  floor.half_side_m = 30.0 * robot.bounding_radius_m;  // its walls are out of sight
  film::Picture picture;
  picture.robots.push_back({.root = {.position_m = {0.0, 0.0, -bounds.min().z()}, .orientation = Eigen::Quaterniond::Identity()},
                            .joint_angles_rad = {},
                            .colour = species_colour(0)});
  if (plan.has_legend) {
    picture.title = title_of(robot);
    picture.caption = "the ring points forward";
    picture.has_scale = true;
  }
  const double aspect = static_cast<double>(plan.width) / static_cast<double>(plan.height);
  const Eigen::Vector3d centre = bounds.center();
  film::Camera camera{.at_m = {centre.x(), centre.y(), 0.5 * bounds.sizes().z()},
                      .distance_m = 2.7 * bounds.diagonal().norm() * std::max(1.0, 1.2 / aspect),
                      .azimuth_deg = 55.0,
                      .elevation_deg = plan.from_above ? -90.0 : -32.0};
  film::Renderer renderer{robot, floor, plan.width, plan.height, film::Quality::fine};
  film::write_png(plan.out, renderer.draw(picture, camera));
}

}  // namespace trophic::command::replay
#endif
