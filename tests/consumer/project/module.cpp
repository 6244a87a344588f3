// SPDX-License-Identifier: MIT
// A module that a user's Python loads.
#include <cstddef>
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/rules/paper.hpp>

extern "C" std::size_t robots_after(double seconds);

extern "C" std::size_t robots_after(double seconds) {
  trophic::Ecology<trophic::rules::Paper> ecology({.seed = 42}, trophic::backend::Kinematic::Params{});
  ecology.run_until(seconds);
  return ecology.view().robots.size();
}
