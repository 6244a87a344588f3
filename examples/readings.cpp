// SPDX-License-Identifier: MIT
// The paper's experiment with its open choices as parameters: `--set rules.parent.starved.reading=second`. scripts/reproduce runs
// its screening design.
#include <trophic/experiment.hpp>

#include "readings/paper_readings.hpp"

int main(int argc, char** argv) {
  return trophic::experiment<trophic::readings::PaperReadings>(argc, argv);
}
