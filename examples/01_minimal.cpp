// SPDX-License-Identifier: MIT
// The shortest complete experiment: the paper's rules, one run, a folder with its data.
#include <iostream>
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/observe/next_free_folder.hpp>
#include <trophic/observe/progress.hpp>
#include <trophic/observe/run_folder.hpp>
#include <trophic/rules/paper.hpp>

int main() {
  trophic::Ecology<trophic::rules::Paper> ecology({.seed = 42}, trophic::backend::Kinematic::Params{});
  trophic::observe::RunFolder folder(trophic::observe::next_free_folder("runs/minimal"));
  trophic::observe::Progress progress;
  ecology.run_until(6000.0, folder, progress);
  progress.summary(std::cout, ecology.view());
}
