// SPDX-License-Identifier: MIT
// Reads robots from TOML files (format: models/README.md).
#pragma once

#include <trophic/habitat/body/build.hpp>
#include <trophic/habitat/load/models.hpp>
#include <trophic/habitat/robot_model.hpp>

namespace trophic {

/// Reads a robot's design. Throws std::invalid_argument for a file that cannot be found, read or parsed (including two modules
/// on one face, which are a repeated TOML table), and "FILE: KEY = VALUE: must be ..." for its content.
[[nodiscard]] body::Design load_design(std::string_view name_or_path, std::string_view installed = TROPHIC_MODEL_DIR);

/// Loads the robot of a design file, by name ("spider") or path; throws as load_design and build.
[[nodiscard]] RobotModel load_robot(std::string_view name_or_path, std::string_view installed = TROPHIC_MODEL_DIR);

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/habitat/load/robot.ipp>
#endif
