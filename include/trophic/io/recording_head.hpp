// SPDX-License-Identifier: MIT
// Robots and arenas in the header of a recording.
#pragma once

#include <trophic/habitat/arena.hpp>
#include <trophic/habitat/robot_model.hpp>
#include <trophic/io/recording_format.hpp>
#include <trophic/support/json.hpp>

namespace trophic::io::recording {

/// Appearance and kinematics of a robot.
[[nodiscard]] Json json_of(const RobotModel& robot);

[[nodiscard]] Json json_of(const Arena& arena);

/// The units of a recording.
[[nodiscard]] Json json_of(const Units& units);

}  // namespace trophic::io::recording

#if TROPHIC_HEADER_ONLY
#include <trophic/io/recording.ipp>
#endif
