// SPDX-License-Identifier: MIT
// Definitions of shipped_tables.hpp.
#include <tools/tables/shipped_tables.hpp>
#include <trophic/experiment/table_experiment.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/released.hpp>
#include <trophic/worlds/food_chain.hpp>
#include <trophic/worlds/lotka_volterra.hpp>
#include <trophic/worlds/mating_zones.hpp>
#include <trophic/worlds/pond_race.hpp>
#include <trophic/worlds/ponds.hpp>
#include <trophic/worlds/two_foods.hpp>
#include <trophic/worlds/wolf_sheep.hpp>

namespace trophic::command {

std::vector<std::pair<std::string, MakeExperiment>> world_tables() {
  using namespace worlds;
  return rule_tables<Pond, PondWithRefuges, PondWithConditions, PondRace, TwoFoods, FoodChain, WolfSheep, RosenzweigMacArthur,
                     LotkaVolterra, MatingZones>();
}

std::vector<std::pair<std::string, MakeExperiment>> shipped_tables() {
  auto all = rule_tables<rules::Paper, rules::Released>();
  for (auto& one : world_tables()) all.push_back(std::move(one));
  return all;
}

}  // namespace trophic::command
