// SPDX-License-Identifier: MIT
// Every public header but the command line's, and one function. What it asks for is asked for in main.cpp, too.
#include <trophic/trophic.hpp>
#ifdef CONSUMER_HAS_mujoco
#include <trophic/backend/mujoco.hpp>
#endif
#ifdef CONSUMER_HAS_ode
#include <trophic/backend/ode.hpp>
#endif
#ifdef CONSUMER_HAS_mpi
#include <trophic/mpi/find_team.hpp>
#endif

double first_draw_of_other_unit();

double first_draw_of_other_unit() {
  return trophic::Rng{42, trophic::Stream::user}.uniform();
}
