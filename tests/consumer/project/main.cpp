// SPDX-License-Identifier: MIT
// A user's program: it links, finds the models and steps a robot. With CONSUMER_EVERYTHING it includes every public header but
// the command line's, lives for a while and has a second part.
#include <iostream>
#ifdef CONSUMER_EVERYTHING
#include <trophic/trophic.hpp>
#ifdef CONSUMER_HAS_ode
#include <trophic/backend/ode.hpp>
#endif
#endif
#include <trophic/habitat/habitat.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/habitat/load/models.hpp>
#include <trophic/habitat/pose.hpp>
#include <trophic/support/rng.hpp>
#ifdef CONSUMER_HAS_mujoco
#include <trophic/backend/mujoco.hpp>
#endif
#include <vector>

#ifdef CONSUMER_EVERYTHING
double first_draw_of_other_unit();
#endif

int main() {
#ifdef CONSUMER_EVERYTHING
  if (trophic::Rng{42, trophic::Stream::user}.uniform() != first_draw_of_other_unit()) {
    std::cerr << "two translation units draw different numbers\n";
    return 1;
  }
  trophic::Ecology<trophic::rules::Paper> ecology({.seed = 42}, trophic::backend::Kinematic::Params{});
  ecology.run_until(20.0);
  std::cout << ecology.view().robots.size() << " robots lived " << ecology.time_s() << " s\n";
#endif
  const trophic::Habitat habitat = trophic::load_habitat({});
  std::cout << habitat.robot.name << " in " << habitat.arena.name << ", from "
            << trophic::find_model(trophic::ModelKind::robot, "spider") << '\n';
#ifdef CONSUMER_HAS_mujoco
  const std::vector<trophic::Pose> start(1, {.position_m = {0.0, 0.0, habitat.robot.rest_height_m}});
  trophic::backend::Mujoco backend{habitat.robot, habitat.arena, start, {}, {}};
  backend.advance_to(0.1);
  std::cout << trophic::backend::Mujoco::version() << ": " << backend.pose(0).position_m.z() << " m\n";
#endif
}
