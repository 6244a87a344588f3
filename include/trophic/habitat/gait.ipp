// SPDX-License-Identifier: MIT
// Definitions of gait.hpp.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <trophic/habitat/gait.hpp>
#include <trophic/habitat/robot_model.hpp>

namespace trophic {

TROPHIC_INLINE void validate(const Gait& gait) {
  const auto fail = [&](const std::string& what) { throw std::invalid_argument{"gait " + gait.name + ": " + what}; };
  const auto n = static_cast<Eigen::Index>(gait.hinges.size());
  if (gait.internal.size() != n) {
    fail("internal has " + std::to_string(gait.internal.size()) + " weights: must have one per hinge, " + std::to_string(n));
  }
  if (gait.coupling.rows() != n || gait.coupling.cols() != n)
    fail("coupling: must be " + std::to_string(n) + " x " + std::to_string(n));
  if (!gait.internal.allFinite() || !gait.coupling.allFinite()) fail("weights must be finite");
  if (gait.coupling != -gait.coupling.transpose()) fail("coupling: must be antisymmetric");
}

TROPHIC_INLINE void check_fit(const Gait& gait, const RobotModel& robot) {
  validate(gait);
  const std::string whose = "gait " + gait.name + " does not fit robot " + robot.name + ": ";
  if (gait.hinges.size() != robot.hinges.size()) {
    throw std::invalid_argument{whose + std::to_string(gait.hinges.size()) + " hinges, the robot has " +
                                std::to_string(robot.hinges.size())};
  }
  for (std::size_t i = 0; i < gait.hinges.size(); ++i) {
    if (gait.hinges[i] != robot.hinges[i].name) {
      throw std::invalid_argument{whose + "hinge " + std::to_string(i) + " is \"" + gait.hinges[i] + "\", the robot's is \"" +
                                  robot.hinges[i].name + "\""};
    }
    for (std::size_t j = 0; j < gait.hinges.size(); ++j) {
      const bool coupled = gait.coupling(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) != 0.0;
      if (coupled && !std::ranges::binary_search(robot.hinge_neighbours[i], j)) {
        throw std::invalid_argument{whose + "\"" + gait.hinges[i] + "\" and \"" + gait.hinges[j] +
                                    "\" are coupled but not neighbours"};
      }
    }
  }
}

}  // namespace trophic
