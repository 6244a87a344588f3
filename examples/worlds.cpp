// SPDX-License-Identifier: MIT
// Living worlds, in which energy decides who lives and numbers change: docs/worlds.md.
#include <trophic/experiment.hpp>
#include <trophic/worlds/food_chain.hpp>
#include <trophic/worlds/lotka_volterra.hpp>
#include <trophic/worlds/ponds.hpp>
#include <trophic/worlds/wolf_sheep.hpp>

int main(int argc, char** argv) {
  using namespace trophic::worlds;
  return trophic::experiment<Pond, PondWithRefuges, PondWithConditions, FoodChain, WolfSheep, RosenzweigMacArthur, LotkaVolterra>(
      argc, argv);
}
