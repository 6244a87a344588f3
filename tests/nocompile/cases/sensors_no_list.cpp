// SPDX-License-Identifier: MIT
// A sensor alone where a list of sensors is wanted.
// expect: the policy in Rules::Sensors needs to be a perception::sensors::List<...>
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/rules/paper.hpp>

int main() {
#ifdef VALID
  using Sensors = trophic::perception::sensors::List<trophic::perception::sensors::SideOfAdversary>;
#else
  using Sensors = trophic::perception::sensors::SideOfAdversary;
#endif
  trophic::Ecology<trophic::with_sensors<trophic::rules::Paper, Sensors>> ecology{{}, trophic::backend::Kinematic::Params{}};
  ecology.run_until(10.0);
}
