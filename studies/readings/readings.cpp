// SPDX-License-Identifier: MIT
// The paper's experiment with its open choices as parameters: `--set rules.parent.starved.reading=second`. studies/reproduce runs
// its screening design.
#include <trophic/experiment.hpp>

#include "paper_readings.hpp"

int main(int argc, char** argv) {
  return trophic::experiment<trophic::readings::PaperReadings>(argc, argv);
}
