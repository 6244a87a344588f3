// SPDX-License-Identifier: MIT
// The paper's experiment: predators and prey, modular robots, one arena. `trophic-predator-prey --help` lists the options.
#include <trophic/experiment.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/released.hpp>

int main(int argc, char** argv) {
  return trophic::experiment<trophic::rules::Paper, trophic::rules::Released>(argc, argv);
}
