// SPDX-License-Identifier: MIT
// Robots from TOML files (format: models/README.md).
#pragma once

#include <string_view>
#include <trophic/habitat/body/build.hpp>
#include <trophic/habitat/load/models.hpp>
#include <trophic/habitat/robot_model.hpp>
#include <trophic/support/linkage.hpp>

namespace trophic {

/// Reads a robot's design. Throws std::invalid_argument for a file that cannot be found, read or parsed (two modules on one face
/// are a repeated TOML table, so they are among these), and "FILE: KEY = VALUE: must be ..." for its content.
[[nodiscard]] body::Design load_design(std::string_view name_or_path, std::string_view installed = TROPHIC_MODEL_DIR);

/// The robot of a design file, by name ("spider") or path; errors as load_design and build.
[[nodiscard]] RobotModel load_robot(std::string_view name_or_path, std::string_view installed = TROPHIC_MODEL_DIR);

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/habitat/load/robot.ipp>
#endif
