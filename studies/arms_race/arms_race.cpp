// SPDX-License-Identifier: MIT
// The studies of studies/results/arms-race.md and red-queen.md: does a criterion for the reproduction of prey, or prey that age,
// start an arms race?
#include <trophic/experiment.hpp>

#include "ecologies.hpp"

int main(int argc, char** argv) {
  using namespace trophic::arms_race;
  return trophic::experiment<Paper, PaperLastEscapee, PaperMostEscapes, PaperFastestEscape, PaperAgeing, PaperLastEscapeeAgeing,
                             PaperMostEscapesAgeing, PaperFastestEscapeAgeing, PaperAfterEscapes, Released, ReleasedMostEscapes,
                             ReleasedAgeing, ReleasedMostEscapesAgeing, PaperRoom, PaperMostEscapesRoom, PaperBySide,
                             ReleasedBySide, PondBySide, GrowingBySide>(argc, argv);
}
