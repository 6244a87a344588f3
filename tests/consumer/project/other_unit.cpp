// SPDX-License-Identifier: MIT
// A second part of the program, with headers that main.cpp has, too.
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/support/rng.hpp>

double first_draw_of_other_unit();

double first_draw_of_other_unit() {
  return trophic::Rng{42, trophic::Stream::user}.uniform();
}
