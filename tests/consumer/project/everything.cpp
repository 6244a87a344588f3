// SPDX-License-Identifier: MIT
#include "everything.hpp"

double first_draw_of_other_unit() {
  return trophic::Rng{42, trophic::Stream::user}.uniform();
}
