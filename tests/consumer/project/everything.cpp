// SPDX-License-Identifier: MIT
// Everything public, in a second translation unit: what is included is there, and nothing that is not inline is defined twice.
#include <trophic/trophic.hpp>
#ifdef CONSUMER_HAS_mujoco
#include <trophic/backend/mujoco.hpp>
#endif
#ifdef CONSUMER_HAS_ode
#include <trophic/backend/ode.hpp>
#endif

double first_draw_of_other_unit();
double first_draw_of_other_unit() {
  return trophic::Rng{42, trophic::Stream::user}.uniform();
}
