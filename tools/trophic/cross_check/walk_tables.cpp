// SPDX-License-Identifier: MIT
// Definitions of walk_tables.hpp.
#include <tools/trophic/cross_check/walk_tables.hpp>

namespace trophic::command::cross_check {

void WalkTables::write(const Outcome& outcome) {
  const Condition& c = outcome.condition;
  for (std::size_t robot = 0; robot < outcome.walks.size(); ++robot) {
    const Walk& walk = outcome.walks[robot];
    walks_.write({.engine = c.engine,
                  .settings = c.settings,
                  .timestep_s = c.timestep_s,
                  .target_angle_rad = c.target_angle_rad,
                  .robot = robot,
                  .speed_m_s = walk.speed_m_s,
                  .turn_rate_rad_s = walk.turn_rate_rad_s,
                  .power_W = walk.power_W,
                  .torque_N_m = walk.torque_N_m});
    for (std::size_t i = 0; i < walk.path.size(); ++i) {
      paths_.write({.engine = c.engine,
                    .settings = c.settings,
                    .timestep_s = c.timestep_s,
                    .target_angle_rad = c.target_angle_rad,
                    .robot = robot,
                    .time_s = sample_s * static_cast<double>(i),
                    .x_m = walk.path[i].x_m,
                    .y_m = walk.path[i].y_m,
                    .heading_rad = walk.path[i].heading_rad});
    }
  }
  walks_.flush();
  paths_.flush();
}

}  // namespace trophic::command::cross_check
