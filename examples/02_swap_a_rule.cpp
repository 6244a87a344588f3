// SPDX-License-Identifier: MIT
// Swaps one rule of the paper: what if offspring shared their parent's genome, as in the released code?
#include <iostream>
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/observe/progress.hpp>
#include <trophic/reproduction/heredity/shared_copy.hpp>
#include <trophic/rules/paper.hpp>

using Rules = trophic::with_heredity<trophic::rules::Paper, trophic::reproduction::heredity::SharedCopy>;

int main() {
  trophic::Ecology<Rules> ecology({.seed = 42}, trophic::backend::Kinematic::Params{});
  trophic::observe::Progress progress;
  ecology.run_until(6000.0, progress);
  progress.summary(std::cout, ecology.view());
}
