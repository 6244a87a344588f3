// SPDX-License-Identifier: MIT
// The pond on three levels: grazers, hunters and apex predators.
#pragma once

#include <trophic/initialization/community/food_chain.hpp>
#include <trophic/rules/with.hpp>
#include <trophic/worlds/pond.hpp>

namespace trophic::worlds {

inline constexpr auto food_chain_params = [](auto& params) {
  params.community = {.hunters = 40, .apex = 15};
  params.activation = {.distance_m = 3.0};
  params.capture = {.reach_m = 0.4, .min_age_s = 20.0};
  params.resource = {.cells_in_a_row = 20, .capacity_J_m2 = 30.0, .growth_1_s = 0.006, .seed_1_s = 0.002, .season = 0.0};
  params.metabolism.template get<0>() = {
      .first_J = 30.0, .capacity_J = 200.0, .resting_W = 0.05, .walking_J_per_m = 1.0, .bite_W = 0.4};
  params.metabolism.template get<1>() = {
      .first_J = 30.0, .capacity_J = 300.0, .resting_W = 0.02, .walking_J_per_m = 0.3, .bite_W = 0.0, .efficiency = 0.7};
  params.metabolism.template get<2>() = {
      .first_J = 30.0, .capacity_J = 300.0, .resting_W = 0.03, .walking_J_per_m = 0.6, .bite_W = 0.0, .efficiency = 0.5};
  params.recruitment.template get<0>() = {.spare_bodies = 400, .birth_J = 60.0, .share = 0.5};
  params.recruitment.template get<1>() = {.birth_J = 50.0, .share = 0.5};
  params.recruitment.template get<2>() = {.birth_J = 100.0, .share = 0.5};
};
inline constexpr auto food_chain_ecology = [](EcologyParams& ecology) {
  ecology.robots = 700;
  ecology.duration_s = 4000.0;
};

/// Rules: like Pond, with apex predators that eat hunters. A meal is part of the victim's energy, so each level has less energy
/// to live on than the one below it.   Source: not in the paper. All parameters are free.   Units: J, m, s.
using FoodChain = named<with_ecology<with_params<with_recruitment<with_community<Pond, initialization::community::FoodChain>,
                                                                  rules::by_species<reproduction::recruitment::AtEnergy>>,
                                                 food_chain_params>,
                                     food_chain_ecology>,
                        "food_chain">;

}  // namespace trophic::worlds
