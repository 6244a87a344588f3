// SPDX-License-Identifier: MIT
// alone
// expect: reads the robot, arena and gait that params.ecology names, and this program has no reader of model files
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/rules/paper.hpp>
#ifdef VALID
#include <trophic/habitat/load/habitat.hpp>
#endif

int main() {
  trophic::Ecology<trophic::rules::Paper> ecology({.seed = 1}, trophic::backend::Kinematic::Params{});
  ecology.run_until(1.0);
}
