// SPDX-License-Identifier: MIT
// Pictures without a screen.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <tools/film/renderer.hpp>
#include <trophic/habitat/load/arena.hpp>
#include <trophic/habitat/load/robot.hpp>

using namespace trophic;

namespace {

/// The share of pixels that are closer to blue than to any other colour.
double blue_share(const film::Image& image) {
  std::size_t blue = 0;
  for (std::size_t at = 0; at < image.rgb.size(); at += 3) {
    const int others = std::max(image.rgb[at], image.rgb[at + 1]);
    if (image.rgb[at + 2] > others + 60) ++blue;
  }
  return static_cast<double>(blue) / static_cast<double>(image.width * image.height);
}

}  // namespace

TEST_CASE("film: picture without a screen -> the robot in its colour, and none where there is none") {
  const RobotModel robot = load_robot("spider");
  const Arena arena = load_arena("walled_square");
  film::Renderer renderer{robot, arena, 320, 240, film::Quality::fast};
  film::Picture picture;
  const film::Camera camera = film::near(robot, Eigen::Vector3d::Zero());
  CHECK(blue_share(renderer.draw(picture, camera)) == 0.0);
  picture.robots.push_back(
      {.root = {.position_m = {0.0, 0.0, robot.rest_height_m}}, .joint_angles_rad = {}, .colour = {0.1F, 0.2F, 0.9F}});
  const double seen = blue_share(renderer.draw(picture, camera));
  CHECK(seen > 0.005);
  CHECK(seen < 0.2);
}
