// SPDX-License-Identifier: MIT
// Definitions of cppn_gait.hpp.
#include <tools/gait_evolution/cppn_gait.hpp>

#include <Eigen/Core>

namespace trophic::gait_evolution {

Gait cppn_gait(const Genome& genome, const RobotModel& robot) {
  const Network network{genome};
  const auto n = static_cast<Eigen::Index>(robot.hinges.size());
  Gait gait{.name = robot.name + "_cppn",
            .robot = robot.name,
            .provenance = "queried from a CPPN",
            .hinges = {},
            .internal = Eigen::VectorXd::Zero(n),
            .coupling = Eigen::MatrixXd::Zero(n, n)};
  for (std::size_t i = 0; i < robot.hinges.size(); ++i) {
    const Eigen::Vector3i& cell = robot.hinges[i].grid_position;
    const auto row = static_cast<Eigen::Index>(i);
    gait.hinges.push_back(robot.hinges[i].name);
    gait.internal[row] = network(cell, cell);
    for (const std::size_t j : robot.hinge_neighbours[i]) {
      if (j <= i) continue;
      const auto column = static_cast<Eigen::Index>(j);
      gait.coupling(row, column) = network(cell, robot.hinges[j].grid_position);
      gait.coupling(column, row) = -gait.coupling(row, column);
    }
  }
  return gait;
}

}  // namespace trophic::gait_evolution
