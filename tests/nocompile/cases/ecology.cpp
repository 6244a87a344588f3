// SPDX-License-Identifier: MIT
// An ecology without a command line.
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/rules/paper.hpp>

int main() {
  using Ecology = trophic::Ecology<trophic::named<trophic::rules::Paper, "mine">>;
  Ecology named(Ecology::Params{.seed = 42}, trophic::backend::Kinematic::Params{});
  Ecology ecology({.seed = 1}, trophic::backend::Kinematic::Params{});
  ecology.run_until(1.0);
}
