// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <support/temporary_folder.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/economy.hpp>
#include <trophic/energy/metabolism/grazing_by_diet.hpp>
#include <trophic/energy/resource/delayed_patches.hpp>
#include <trophic/energy/resource/foods.hpp>
#include <trophic/energy/resource/logistic_field.hpp>
#include <trophic/params/named_params.hpp>
#include <trophic/worlds/two_foods.hpp>

using namespace trophic;
using namespace trophic::test;
using energy::metabolism::Diet;
using energy::metabolism::GrazingByDiet;
using energy::resource::DelayedPatches;
using energy::resource::Food;
using energy::resource::Foods;
using energy::resource::LogisticField;

namespace {

using GrassAndNuts = Foods<Food<"grass", LogisticField>, Food<"nuts", DelayedPatches>>;

[[nodiscard]] GrassAndNuts grass_and_nuts() {
  GrassAndNuts::Params params;
  params.get<0>() = {.cells_in_a_row = 4, .capacity_J_m2 = 10.0, .growth_1_s = 0.0, .seed_1_s = 0.01, .season = 0.0};
  params.get<1>() = {.patches_in_a_row = 2, .patch_J = 3.0, .delay_ticks = 2, .grown = 1.0};
  return GrassAndNuts{params};
}

/// Prey with these diets, with room for all that they bite.
[[nodiscard]] HandPopulation eaters(const std::vector<double>& diets, std::size_t foods) {
  HandPopulation robots{std::vector<Robot>(diets.size())};
  robots.traits = {Diet::name};
  for (std::size_t body = 0; body < diets.size(); ++body) {
    robots.individuals[body].genome = std::make_shared<Genome>(Genome{.id = body, .traits = {diets[body]}});
    robots.individuals[body].energy_J = 1.0;
  }
  robots.foods.assign(foods, ResourceField{robots.arena, 1});
  return robots;
}

[[nodiscard]] GrazingByDiet<> diner(double tradeoff) {
  return GrazingByDiet<>{{.energy = {.capacity_J = 100.0, .bite_W = 2.0}, .tradeoff = tradeoff}};
}

}  // namespace

TEST_CASE("foods: names, parameters and policy -> of each food under its name") {
  CHECK(GrassAndNuts::name == "grass: logistic_field, nuts: delayed_patches");
  CHECK(energy::food_names<GrassAndNuts>.size() == 2);
  CHECK(energy::food_names<GrassAndNuts>[1] == "nuts");
  CHECK(energy::food_names<LogisticField>.empty());
  const NamedParams params = named_params_of(grass_and_nuts().params);
  CHECK(params.front().path == "grass.cells_in_a_row");
  CHECK(params.back().path == "nuts.grown");
  CHECK(grass_and_nuts().why_no_effect("grass.year_s", predator_prey_web(), {}) == "without a season");
  CHECK(grass_and_nuts().why_no_effect("nuts.grown", predator_prey_web(), {}).empty());
}

TEST_CASE("foods: growth and bites -> of each food by its own rule on its own grid") {
  const GrassAndNuts rule = grass_and_nuts();
  HandPopulation world{{}};
  world.arena.half_side_m = 2.0;
  Rng rng{1, Stream::user};
  std::vector<ResourceField> foods = rule.start(world.arena, rng);
  REQUIRE(foods.size() == 2);
  CHECK(foods[0].total_J() == doctest::Approx(160.0));
  CHECK(foods[1].total_J() == doctest::Approx(12.0));
  foods[0].food_J(3) -= 5.0;
  rule.on_bite(foods, 0, 3, 5.0, 0, world.view());
  CHECK(foods[0].food_J(3) == doctest::Approx(5.0));
  CHECK(foods[1].food_J(3) == doctest::Approx(3.0));
  foods[1].food_J(3) -= 1.0;
  rule.on_bite(foods, 1, 3, 1.0, 0, world.view());
  CHECK(foods[1].food_J(3) == 0.0);
  rule.grow(foods, world.at_tick(1).view(), rng);
  CHECK(foods[0].food_J(3) == doctest::Approx(5.0 + 2.0 * 0.01 * 10.0));
  CHECK(foods[1].food_J(3) == 0.0);
  for (int tick = 2; tick <= 3; ++tick) rule.grow(foods, world.at_tick(tick).view(), rng);
  CHECK(foods[1].food_J(3) == 3.0);
}

TEST_CASE("grazing by diet: two foods -> specialists bite one at the full rate, generalists both at less") {
  const HandPopulation robots = eaters({0.0, 1.0, 0.5, 0.25}, 2);
  const View view = robots.view();
  const auto bites = [&](const GrazingByDiet<>& rule, BodyIndex body) {
    return std::pair{rule.bite_J(body, 0, 50.0, view), rule.bite_J(body, 1, 50.0, view)};
  };
  const GrazingByDiet<> squares = diner(2.0);
  CHECK(bites(squares, 0) == std::pair{4.0, 0.0});  // 2 W for 2 s
  CHECK(bites(squares, 1) == std::pair{0.0, 4.0});
  CHECK(bites(squares, 2) == std::pair{1.0, 1.0});
  CHECK(bites(squares, 3) == std::pair{4.0 * 0.5625, 4.0 * 0.0625});
  CHECK(bites(diner(1.0), 2) == std::pair{2.0, 2.0});
  CHECK(squares.bite_J(0, 0, 1.5, view) == 1.5);  // what is there
  CHECK(squares.bite_J(2, 0, 1.5, view) == 0.75);
}

TEST_CASE("grazing by diet: waste -> what a grazer takes of a food and does not gain, none of a specialist") {
  const HandPopulation robots = eaters({0.0, 0.5, 0.25}, 2);
  const View view = robots.view();
  const GrazingByDiet<> rule = diner(2.0);
  CHECK(rule.waste_J(0, 0, 4.0, view) == 0.0);
  CHECK(rule.waste_J(0, 1, 0.0, view) == 0.0);
  CHECK(rule.waste_J(1, 0, 1.0, view) == 1.0);  // it takes 2 J, half of its bite
  CHECK(rule.waste_J(1, 0, 0.75, view) == 0.75);
  CHECK(rule.waste_J(2, 1, 0.25, view) == 0.75);
  CHECK(diner(1.0).waste_J(1, 0, 2.0, view) == 0.0);
}

TEST_CASE("grazing by diet: three foods or one -> diets lie between neighbours, or there is one for all") {
  const HandPopulation three = eaters({0.0, 0.5, 0.75}, 3);
  const GrazingByDiet<> rule = diner(1.0);
  const auto bites = [&](BodyIndex body) {
    return std::array{rule.bite_J(body, 0, 50.0, three.view()), rule.bite_J(body, 1, 50.0, three.view()),
                      rule.bite_J(body, 2, 50.0, three.view())};
  };
  CHECK(bites(0) == std::array{4.0, 0.0, 0.0});
  CHECK(bites(1) == std::array{0.0, 4.0, 0.0});
  CHECK(bites(2) == std::array{0.0, 2.0, 2.0});
  CHECK(rule.bite_J(0, 0, 50.0, eaters({0.7}, 1).view()) == 4.0);
}

TEST_CASE("grazing by diet: hunters and full prey -> no bite") {
  HandPopulation robots = eaters({0.5, 0.5}, 2);
  robots.individuals[0].species = predator;
  robots.individuals[1].energy_J = 100.0;
  for (const BodyIndex body : {BodyIndex{0}, BodyIndex{1}}) CHECK(diner(2.0).bite_J(body, 0, 50.0, robots.view()) == 0.0);
}

TEST_CASE("foods: resource of another number of foods in a checkpoint -> refused by name") {
  const auto rules = make_policies<worlds::TwoFoods>(RuleParams<worlds::TwoFoods>{});
  const auto one_rule = make_policies<worlds::Pond>(RuleParams<worlds::Pond>{});
  const Habitat habitat{};
  FoodSupply<worlds::TwoFoods> two{rules, 1, &habitat};
  FoodSupply<worlds::Pond> one{one_rule, 1, &habitat};
  Archive written;
  written(two);
  Archive again{written.bytes()};
  FoodSupply<worlds::TwoFoods> same{rules, 2, &habitat};
  again(same);
  again.finish();
  CHECK(same.fields()[1].total_J() == two.fields()[1].total_J());
  Archive other{written.bytes()};
  CHECK(message_of<std::invalid_argument>([&] { other(one); }).find("a resource of a different number of foods") !=
        std::string::npos);
}
