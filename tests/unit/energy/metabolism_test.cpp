// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/energy/metabolism/falling_energy.hpp>
#include <trophic/energy/metabolism/fixed_gains.hpp>
#include <trophic/energy/metabolism/grazing_and_hunting.hpp>
#include <trophic/energy/metabolism/no_metabolism.hpp>

using namespace trophic;
using namespace trophic::test;
using energy::metabolism::GrazingAndHunting;

namespace {

/// A prey and a predator with these energies.
HandPopulation pair(double prey_J, double predator_J) {
  HandPopulation robots{{{.species = prey}, {.species = predator, .x_m = 0.5}}};
  robots.individuals[0].energy_J = prey_J;
  robots.individuals[1].energy_J = predator_J;
  return robots;
}

constexpr GrazingAndHunting rule{{.first_J = 50.0,
                                  .spread = 0.0,
                                  .capacity_J = 100.0,
                                  .resting_W = 0.1,
                                  .walking_J_per_m = 2.0,
                                  .bite_W = 1.5,
                                  .efficiency = 0.5}};

}  // namespace

TEST_CASE("grazing and hunting: upkeep by hand -> at rest for a tick of 2 s, and by the metre") {
  const HandPopulation robots = pair(10.0, 10.0);
  CHECK(rule.upkeep_J(0, 0.0, robots.view()) == doctest::Approx(0.2));
  CHECK(rule.upkeep_J(1, 0.25, robots.view()) == doctest::Approx(0.7));
}

TEST_CASE("grazing and hunting: bites -> at most the mouth, what is there and what has room, for grazers only") {
  CHECK(rule.bite_J(0, 0, 10.0, pair(10.0, 10.0).view()) == doctest::Approx(3.0));
  CHECK(rule.bite_J(0, 0, 1.0, pair(10.0, 10.0).view()) == doctest::Approx(1.0));
  CHECK(rule.bite_J(0, 0, 10.0, pair(98.0, 10.0).view()) == doctest::Approx(2.0));
  CHECK(rule.bite_J(0, 0, 10.0, pair(120.0, 10.0).view()) == 0.0);
  CHECK(rule.bite_J(1, 0, 10.0, pair(10.0, 10.0).view()) == 0.0);
}

TEST_CASE("grazing and hunting: act Eat in the table -> only those bite that chose to") {
  const HandPopulation robots{{{.species = prey}, {.species = prey}}};
  const char* const eat = &detail::act_key<control::acts::Eat>;
  const std::vector<double> chosen{0.0, 1.0};
  View view = robots.view();
  view.acts = {.acts = {&eat, 1}, .values = chosen};
  CHECK(rule.bite_J(0, 0, 10.0, view) == 0.0);
  CHECK(rule.bite_J(1, 0, 10.0, view) == doctest::Approx(3.0));
}

TEST_CASE("grazing and hunting: a meal -> a share of what the victim has, at most what has room") {
  CHECK(rule.meal_J(1, 0, pair(40.0, 10.0).view()) == doctest::Approx(20.0));
  CHECK(rule.meal_J(1, 0, pair(40.0, 95.0).view()) == doctest::Approx(5.0));
  CHECK(rule.meal_J(1, 0, pair(-1.0, 10.0).view()) == 0.0);
}

TEST_CASE("grazing and hunting: starves at 0 J") {
  CHECK(rule.starves(0, pair(0.0, 1.0).view()));
  CHECK_FALSE(rule.starves(1, pair(0.0, 1.0).view()));
}

TEST_CASE("grazing and hunting: first energies -> first_J, or uniform around it, never more than the capacity") {
  Rng rng{1, Stream::user};
  const Individual newborn;
  CHECK(rule.first_J(newborn, rng) == 50.0);
  const GrazingAndHunting spread{{.first_J = 80.0, .spread = 0.5, .capacity_J = 100.0}};
  double least_J = 1e9;
  double most_J = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const double first_J = spread.first_J(newborn, rng);
    least_J = std::min(least_J, first_J);
    most_J = std::max(most_J, first_J);
  }
  CHECK(least_J >= 40.0);
  CHECK(least_J < 41.0);
  CHECK(most_J == 100.0);
}

TEST_CASE("fixed gains: by hand -> a price for each tick, a bite for grazers, a bonus for hunters, whole numbers at first") {
  const energy::metabolism::FixedGains fixed{{.gain_J = 4.0, .tick_J = 1.5}};
  const HandPopulation robots = pair(-0.1, 0.0);
  CHECK(fixed.upkeep_J(0, 9.0, robots.view()) == 1.5);
  CHECK(fixed.bite_J(0, 0, 9.0, robots.view()) == 4.0);
  CHECK(fixed.bite_J(0, 0, 3.0, robots.view()) == 3.0);
  CHECK(fixed.bite_J(1, 0, 9.0, robots.view()) == 0.0);
  CHECK(fixed.meal_J(1, 0, robots.view()) == 0.0);
  CHECK(fixed.bonus_J(1, 0, robots.view()) == 4.0);
  CHECK(fixed.starves(0, robots.view()));
  CHECK_FALSE(fixed.starves(1, robots.view()));
  Rng rng{1, Stream::user};
  std::vector<int> drawn(8);
  for (int i = 0; i < 8000; ++i) ++drawn.at(static_cast<std::size_t>(fixed.first_J({}, rng)));
  for (const int of_each : drawn) CHECK(of_each == doctest::Approx(1000.0).epsilon(0.15));
}

TEST_CASE("no metabolism: individuals have, spend and need no energy") {
  const energy::metabolism::NoMetabolism none;
  const HandPopulation robots = pair(0.0, 0.0);
  Rng rng{1, Stream::user};
  CHECK(none.first_J(robots.individuals[0], rng) == 0.0);
  CHECK(none.upkeep_J(0, 9.0, robots.view()) == 0.0);
  CHECK(none.bite_J(0, 0, 9.0, robots.view()) == 0.0);
  CHECK(none.meal_J(1, 0, robots.view()) == 0.0);
  CHECK_FALSE(none.starves(0, robots.view()));
}

TEST_CASE("falling energy: by hand -> a price for time alone, all food up to the capacity, a grant up to that of a newborn") {
  const energy::metabolism::FallingEnergy falling{{.first_J = 90.0, .newborn_J = 100.0, .loss_W = 0.5, .capacity_J = 100.0}};
  const HandPopulation robots = pair(97.0, 0.0);
  CHECK(falling.upkeep_J(0, 9.0, robots.view()) == 1.0);
  CHECK(falling.bite_J(0, 0, 9.0, robots.view()) == 3.0);
  CHECK(falling.bite_J(0, 0, 2.0, robots.view()) == 2.0);
  CHECK(falling.meal_J(1, 0, robots.view()) == 0.0);
  CHECK(falling.grant_J(robots.individuals[0]) == 3.0);
  CHECK(falling.grant_J(robots.individuals[1]) == 100.0);
  CHECK(energy::metabolism::FallingEnergy{{.newborn_J = 0.0}}.grant_J(robots.individuals[0]) == 0.0);
  CHECK_FALSE(falling.starves(0, robots.view()));
  CHECK(falling.starves(1, robots.view()));
  const HandPopulation rich = pair(130.0, 0.0);
  CHECK(falling.bite_J(0, 0, 9.0, rich.view()) == 0.0);
  CHECK(falling.grant_J(rich.individuals[0]) == 0.0);
}
