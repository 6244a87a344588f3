// SPDX-License-Identifier: MIT
// The shortest complete experiment: the paper's rules, one run, a folder with its data.
#include <trophic/backend/kinematic.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/run.hpp>

int main() {
  trophic::Ecology<trophic::rules::Paper> ecology({.seed = 42}, trophic::backend::Kinematic::Params{});
  trophic::run_in_new_folder(ecology, 6000.0, "runs/minimal");
}
