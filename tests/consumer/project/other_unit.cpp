// SPDX-License-Identifier: MIT
// A second part of the program, with headers that main.cpp has, too, and a world of trophic's with another rule.
#include <trophic/energy/metabolism/fixed_gains.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/rules/with.hpp>
#include <trophic/support/rng.hpp>
#include <trophic/worlds/pond.hpp>

double first_draw_of_other_unit();

double first_draw_of_other_unit() {
  return trophic::Rng{42, trophic::Stream::user}.uniform();
}

using Own = trophic::named<trophic::with_metabolism<trophic::worlds::Pond, trophic::energy::metabolism::FixedGains>, "own_pond">;

std::size_t hunters_of_own_pond();

std::size_t hunters_of_own_pond() {
  return Own::params().community.predators;
}
