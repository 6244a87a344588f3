// SPDX-License-Identifier: MIT
// The study of studies/results/open-ended.md: does complexity grow without end if space and limits do?
#include <trophic/experiment.hpp>

#include "tables.hpp"

int main(int argc, char** argv) {
  return trophic::experiment<trophic::open_ended::GrowingRace, trophic::open_ended::GrowingRaceTwoFoods>(argc, argv);
}
