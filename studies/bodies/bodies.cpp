// SPDX-License-Identifier: MIT
// The study of studies/bodies/README.md: what evolves if gaits, brains and bodies are inherited?
#include <trophic/experiment.hpp>

#include "tables.hpp"

int main(int argc, char** argv) {
  using namespace trophic::bodies_study;
  return trophic::experiment<EvolvingBodies, EvolvingBodiesBySurvival, EvolvingPond, GaitsRace, EvolvingBrains,
                             EvolvingBrainsBySurvival>(argc, argv);
}
