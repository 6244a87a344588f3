// SPDX-License-Identifier: MIT
// Living worlds, in which energy decides who lives and numbers change: examples/worlds/README.md.
#include <trophic/experiment.hpp>

#include "worlds/food_chain.hpp"
#include "worlds/lotka_volterra.hpp"
#include "worlds/ponds.hpp"
#include "worlds/wolf_sheep.hpp"

int main(int argc, char** argv) {
  using namespace trophic::worlds;
  return trophic::experiment<Pond, PondWithRefuges, PondWithConditions, FoodChain, WolfSheep, RosenzweigMacArthur, LotkaVolterra>(
      argc, argv);
}
