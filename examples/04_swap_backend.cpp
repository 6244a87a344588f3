// SPDX-License-Identifier: MIT
// The same experiment on another engine: only the backend's argument changes.
#include <iostream>
#include <trophic/backend/mujoco.hpp>
#include <trophic/backend/ode.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/observe/progress.hpp>
#include <trophic/rules/paper.hpp>

int main() {
  trophic::Ecology<trophic::rules::Paper> ecology({.seed = 42}, trophic::backend::Ode::Params{});  // or: Mujoco::Params{}
  trophic::observe::Progress progress;
  ecology.run_until(20.0, progress);
  progress.summary(std::cout, ecology.view());
}
