// SPDX-License-Identifier: MIT
// From a CPPN to the weights of a robot's CPG.
#pragma once

#include <tools/gait_evolution/network.hpp>
#include <trophic/habitat/gait.hpp>
#include <trophic/habitat/robot_model.hpp>

namespace trophic::gait_evolution {

/// The gait that a CPPN gives a robot (Sec. "Targeted Steering"): with the grid cells of the hinges, the internal weight of hinge
/// i is CPPN(i, i), the coupling of two neighbours i < j is CPPN(i, j); other hinges are not coupled.
[[nodiscard]] Gait cppn_gait(const Genome& genome, const RobotModel& robot);

}  // namespace trophic::gait_evolution
