// SPDX-License-Identifier: MIT
// The study of studies/results/pond-race.md: a race with a second trait.
#include <trophic/experiment.hpp>

#include "pace_and_sight.hpp"

int main(int argc, char** argv) {
  return trophic::experiment<trophic::race::PondSight>(argc, argv);
}
