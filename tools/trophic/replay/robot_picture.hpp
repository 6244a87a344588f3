// SPDX-License-Identifier: MIT
// A robot file as a picture. Empty for a program that does not link trophic::film.
#pragma once

#ifdef TROPHIC_WITH_FILM
#include <cstddef>
#include <filesystem>
#include <string>

namespace trophic::command::replay {

/// A picture of a robot that stands on the floor.
struct RobotPicture {
  std::string robot;  ///< name or path of a robot file
  std::filesystem::path out;
  std::size_t width = 1280;
  std::size_t height = 720;
  bool from_above = false;
  bool has_legend = true;  ///< name, number of links and hinges, mass, a scale
};

/// Writes the PNG. Throws std::invalid_argument for a robot file that cannot be read, std::runtime_error if nothing can be drawn.
void draw_robot(const RobotPicture& plan);

}  // namespace trophic::command::replay
#endif
