// SPDX-License-Identifier: MIT
// Second translation unit with the same headers: two definitions of anything that is not inline do not link.
#include <trophic/trophic.hpp>
#ifdef CONSUMER_HAS_mujoco
#include <trophic/backend/mujoco.hpp>
#endif

double first_draw_of_other_unit();
double first_draw_of_other_unit() {
  return trophic::Rng{42, trophic::Stream::user}.uniform();
}
