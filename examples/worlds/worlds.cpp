// SPDX-License-Identifier: MIT
// Living worlds, in which energy decides who lives and numbers change: examples/worlds/README.md.
#include <trophic/experiment.hpp>

#include "worlds/pond.hpp"
#include "worlds/wolf_sheep.hpp"

int main(int argc, char** argv) {
  return trophic::experiment<trophic::worlds::Pond, trophic::worlds::WolfSheep>(argc, argv);
}
