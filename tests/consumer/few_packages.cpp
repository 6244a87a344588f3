// SPDX-License-Identifier: MIT
// A self-made habitat on the kinematic backend, without files: needs Eigen and Random123, and nothing to link.
#include <iostream>
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/rules/paper.hpp>

int main() {
  trophic::Habitat habitat;
  habitat.robot.name = "point";
  habitat.robot.links.push_back({.name = "core", .mass_kg = 1.0});
  habitat.robot.bounding_radius_m = 0.2;
  habitat.robot.walk = {.speed_m_s = 0.04, .turn_rate_per_rad = 0.06};
  trophic::Ecology<trophic::rules::Paper> ecology({.seed = 42}, trophic::backend::Kinematic::Params{}, habitat);
  ecology.run_until(200.0);
  std::cout << ecology.view().robots.size() << " robots at " << ecology.view().time_s << " s\n";
}
