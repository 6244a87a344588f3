// SPDX-License-Identifier: MIT
// A pond with two foods, between which prey differ by a heritable diet.
#pragma once

#include <trophic/energy/metabolism/grazing_by_diet.hpp>
#include <trophic/energy/resource/foods.hpp>
#include <trophic/worlds/pond.hpp>

namespace trophic::worlds {

/// The foods of TwoFoods, for other tables.
using GrassAndFruit = energy::resource::Foods<energy::resource::Food<"grass", energy::resource::LogisticField>,
                                              energy::resource::Food<"fruit", energy::resource::LogisticField>>;

/// The numbers of TwoFoods in a table derived from Pond with GrassAndFruit and GrazingByDiet: each food grows as Pond's one.
inline constexpr auto with_two_foods = [](auto& params) {
  const auto pond = Pond::params();
  params.resource.template get<0>() = params.resource.template get<1>() = pond.resource;
  params.metabolism.template get<0>().energy = pond.metabolism.get<0>();
  params.metabolism.template get<0>().energy.bite_W = 0.8;
  params.metabolism.template get<1>().energy = pond.metabolism.get<1>();
};

/// Rules: like Pond, but two foods, grass and fruit, lie on the floor together (Foods), each as Pond's one. Each prey eats them
/// by its heritable Diet (GrazingByDiet): a specialist of one food gains up to 0.8 W, a generalist of both 0.4 W, as prey of Pond
/// do, and destroys as much. Diets begin between the foods.   Source: not in the literature as such. All parameters are free.
using TwoFoods = named<
    with_params<
        with_traits<with_metabolism<with_resource<Pond, GrassAndFruit>, rules::by_species<energy::metabolism::GrazingByDiet<>>>,
                    reproduction::traits::List<energy::metabolism::Diet>>,
        with_two_foods>,
    "two_foods">;

}  // namespace trophic::worlds
