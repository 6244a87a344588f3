// SPDX-License-Identifier: MIT
// The same experiment on another engine: one line differs.
#include <iostream>
#include <trophic/backend/mujoco.hpp>
#include <trophic/ecology.hpp>
#include <trophic/observe/progress.hpp>
#include <trophic/rules/paper.hpp>

using Engine = trophic::backend::Mujoco;  // or Ode from <trophic/backend/ode.hpp>, Kinematic from kinematic.hpp

int main() {
  trophic::Ecology<trophic::rules::Paper, Engine> ecology({.seed = 42});
  trophic::observe::Progress progress;
  ecology.run_until(20.0, progress);
  progress.summary(std::cout, ecology.view());
}
