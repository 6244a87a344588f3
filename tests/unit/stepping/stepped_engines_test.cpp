// SPDX-License-Identifier: MIT
// Decisions from outside on the engines.
#include <doctest/doctest.h>

#include <trophic/backend/mujoco.hpp>
#include <trophic/backend/ode.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/rules/paper.hpp>
#include <unit/stepping/stepped.hpp>

using namespace trophic;

TEST_CASE("stepped run: paper on MuJoCo and ODE, decided by its own brains -> the bytes of the ordinary run") {
  Experiment<rules::Paper> few{.seed = 6};
  few.ecology.robots = 6;
  few.rules.community.predators = 3;
  few.rules.placement.half_extent_m = 1.5;
  few.rules.floor.floor = 1;
  few.rules.minimum_predators.below = 1;
  for (const BackendChoice& backend : {BackendChoice{backend::Mujoco::Params{}}, BackendChoice{backend::Ode::Params{}}}) {
    CAPTURE(backend.name());
    CHECK(test::check_same_bytes([&] { return std::make_unique<Ecology<rules::Paper>>(few, backend); }, 20.0) == 11);
  }
}
