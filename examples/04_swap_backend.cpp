// SPDX-License-Identifier: MIT
// The same experiment on another engine: the line that names the engine is all that changes.
#include <iostream>
#include <trophic/backend/mujoco.hpp>
#include <trophic/backend/ode.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/observe/progress.hpp>
#include <trophic/rules/paper.hpp>

using Engine = trophic::backend::Ode;  // was: trophic::backend::Mujoco

int main() {
  trophic::Ecology<trophic::rules::Paper, Engine> ecology({.seed = 42});
  trophic::observe::Progress progress;
  ecology.run_until(20.0, progress);
  progress.summary(std::cout, ecology.view());
}
