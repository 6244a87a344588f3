// SPDX-License-Identifier: MIT
// The paper's experiment with what its text leaves open as numbers: `--set rules.parent.starved.reading=second`. The script
// scripts/reproduce runs its screening design.
#include <trophic/experiment.hpp>

#include "readings/paper_readings.hpp"

int main(int argc, char** argv) {
  return trophic::experiment<trophic::readings::PaperReadings>(argc, argv);
}
