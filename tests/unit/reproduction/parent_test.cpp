// SPDX-License-Identifier: MIT
// The policies of this slot, each by its name.
#include <doctest/doctest.h>

#include <rapidcheck.h>
#include <map>
#include <support/hand_population.hpp>
#include <trophic/reproduction/parent/any_survivor.hpp>
#include <trophic/reproduction/parent/fastest_escape.hpp>
#include <trophic/reproduction/parent/killer.hpp>
#include <trophic/reproduction/parent/last_escapee.hpp>
#include <trophic/reproduction/parent/last_killer.hpp>
#include <trophic/reproduction/parent/last_seen_victim.hpp>
#include <trophic/reproduction/parent/most_escapes.hpp>
#include <trophic/reproduction/parent/nearest_active_victim.hpp>
#include <trophic/reproduction/parent/nearest_conspecific.hpp>
#include <trophic/reproduction/parent/nearest_victim.hpp>
#include <trophic/reproduction/parent/no_parent.hpp>
#include "unit/reproduction/walks.hpp"

using namespace trophic;
using namespace trophic::test;
using namespace reproduction::parent;

namespace {

const HandPopulation crowd{{{.species = prey, .id = 10},
                            {.species = predator, .id = 20},
                            {.species = predator, .x_m = 3.0, .id = 30},
                            {.species = prey, .id = 40},
                            {.species = predator, .x_m = 9.0, .active = false, .id = 50}}};

}  // namespace

TEST_CASE("any survivor: the killer -> every living hunter equally often, no prey") {
  std::map<IndividualId, int> chosen;
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    Rng rng{seed, Stream::parent};
    const auto parent = AnySurvivor<Killer>{}.parent({.body = 0, .cause = Cause::caught, .killer = 1}, crowd.view(), rng);
    REQUIRE(parent);
    CHECK(parent->species == predator);
    ++chosen[parent->id];
  }
  REQUIRE(chosen.size() == 3);
  for (const auto& [id, times] : chosen) {
    CAPTURE(id);
    CHECK(times > 1000 - 4 * 26);  // 4 standard deviations of a binomial of 3000 and 1/3
    CHECK(times < 1000 + 4 * 26);
  }
}

TEST_CASE("any survivor: the dying individual -> never its own successor's parent") {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Rng rng{seed, Stream::parent};
    const Vacancy death{.body = 0, .cause = Cause::senescence, .successor = prey};
    CHECK(AnySurvivor<NearestConspecific>{}.parent(death, crowd.view(), rng)->id == 40);
  }
}

TEST_CASE("any survivor: a rule that names no parent -> none, without a draw") {
  Rng rng{1, Stream::parent};
  CHECK_FALSE(AnySurvivor<NoParent>{}.parent({.body = 0}, crowd.view(), rng));
  CHECK(rng.bits() == Rng{1, Stream::parent}.bits());
}

TEST_CASE("any survivor: a rule with a state whose parent is dead, none of its species lives -> that parent") {
  const HandPopulation all_prey{{{.species = prey, .id = 10}, {.species = prey, .id = 40}}};
  std::vector<LastKiller::State> states(2);
  states[0].killer = ancestor(7, predator);
  Rng rng{1, Stream::parent};
  const Vacancy death{.body = 0, .cause = Cause::sacrificed, .successor = predator};
  CHECK(AnySurvivor<LastKiller>{}.parent(death, all_prey.view(), rng, states)->id == 7);
  CHECK(AnySurvivor<LastKiller>::name == "any_survivor_last_killer");
}

TEST_CASE("fastest escape: greatest gain of distance within the window -> parent") {
  Walks<FastestEscape> walks{2, FastestEscape{{.window_ticks = 2}}};
  walks.to({1.0, 5.0});
  CHECK(walks.parent() == std::nullopt);
  walks.to({4.0, 5.5});
  CHECK(walks.parent() == 1);  // 3 m against 0.5 m
  walks.to({4.0, 6.0});
  CHECK(walks.parent() == 1);
  walks.to({4.0, 6.5});
  CHECK(walks.parent() == 2);  // 0 m against 1 m
  CHECK(walks.states()[1].x_m == std::vector<double>{4.0, 4.0, 4.0});
  walks.to({3.0, 1.0});
  walks.to({3.0, 1.0});
  CHECK(walks.parent() == std::nullopt);
}

TEST_CASE("fastest escape: a prey younger than the window -> its gain since birth") {
  Walks<FastestEscape> walks{1};
  walks.to({2.0});
  walks.to({3.0});
  CHECK(walks.parent() == 1);
}

TEST_CASE("killer: catch -> the hunter is the parent") {
  const reproduction::parent::Killer rule;
  const HandPopulation robots{
      {{.species = prey}, {.species = predator, .x_m = 0.1, .id = 41}, {.species = predator, .x_m = 0.9, .id = 42}}};
  Rng rng{1, Stream::parent};
  const auto parent = rule.parent({.body = 0, .cause = Cause::caught, .killer = 2}, robots.view(), rng);
  REQUIRE(parent);
  CHECK(parent->id == 42);
  CHECK(parent->species == predator);
  CHECK(parent->genome == robots.individuals[2].genome);
}

TEST_CASE("killer: death without a killer -> no parent") {
  Rng rng{1, Stream::parent};
  const HandPopulation robots{{{.species = prey}, {.species = predator}}};
  CHECK_FALSE(reproduction::parent::Killer{}.parent({.body = 0, .cause = Cause::sacrificed, .killer = {}}, robots.view(), rng));
}

TEST_CASE("last escapee: the latest escape from the dying predator -> parent, not from another one") {
  Walks<LastEscapee> walks{3};
  walks.robots().individuals[3].species = predator;  // at 20 m, then close to prey 2
  walks.to({2.0, 2.0, 20.0});
  walks.to({6.0, 2.0, 20.0});
  CHECK(walks.parent() == 1);
  walks.to({6.0, 6.0, 20.0});
  CHECK(walks.parent() == 2);
  walks.to({6.0, 18.0, 20.0});
  walks.to({19.0, 12.0, 20.0});
  walks.to({6.0, 12.0, 20.0});  // prey 1 escapes from the other predator, after prey 2 did
  CHECK(walks.parent() == 2);
  walks.robots().individuals[0].id = 77;
  CHECK(walks.parent() == std::nullopt);
}

TEST_CASE("last escapee: two at one tick -> the closest, dead predators are forgotten") {
  Walks<LastEscapee> walks{2};
  walks.to({2.0, 1.0});
  walks.to({8.0, 7.0});
  CHECK(walks.parent() == 2);
  walks.robots().individuals[0].id = 77;
  walks.to({2.0, 1.0});
  walks.to({8.0, 7.0});
  CHECK(walks.states()[1].hunters == std::vector<IndividualId>{77});
  CHECK(walks.parent() == 2);
}

TEST_CASE("last killer: catches in this body -> the last hunter, dead or alive") {
  const LastKiller rule;
  const HandPopulation robots{{{.species = prey}, {.species = predator, .x_m = 0.1}}};
  const std::vector<LastKiller::State> states{{.killer = ancestor(77, predator)}, {}};
  const std::vector<LastKiller::State> empty(2);
  Rng rng{1, Stream::parent};
  const auto parent = rule.parent({.body = 0, .cause = Cause::sacrificed, .killer = {}}, robots.view(), rng, states);
  REQUIRE(parent);
  CHECK(parent->id == 77);
  CHECK(parent->genome == states[0].killer->genome);
  CHECK_FALSE(rule.parent({.body = 0, .cause = Cause::sacrificed, .killer = {}}, robots.view(), rng, empty));
  CHECK(rule.parent({.body = 0, .cause = Cause::sacrificed, .successor = predator}, robots.view(), rng, states));
  CHECK_FALSE(rule.parent({.body = 0, .cause = Cause::sacrificed, .successor = prey}, robots.view(), rng, states));
}

TEST_CASE("last killer: birth in the caught body -> killer still remembered") {
  const LastKiller rule;
  const HandPopulation robots{{{.species = prey}, {.species = predator, .x_m = 0.1}}};
  LastKiller::State own{.killer = ancestor(77, predator)};
  rule.on_caught(own, 0, 1, robots.view());
  REQUIRE(own.killer);
  CHECK(own.killer->id == 1);
  CHECK(own.killer->genome == robots.individuals[1].genome);
  CHECK(rule.born({}, nullptr, own).killer == own.killer);
}

TEST_CASE("last seen victim: another prey is closer -> the remembered one, at any distance") {
  const LastSeenVictim rule;
  const HandPopulation robots{{{.species = predator}, {.species = prey, .x_m = 0.1}}};
  const std::vector<LastSeenVictim::State> states{{.body = 1, .victim = ancestor(77, prey)}, {}};
  const std::vector<LastSeenVictim::State> empty(2);
  Rng rng{1, Stream::parent};
  const auto parent = rule.parent({.body = 0, .cause = Cause::starved, .killer = {}}, robots.view(), rng, states);
  CHECK(parent == states[0].victim);
  CHECK_FALSE(rule.parent({.body = 0, .cause = Cause::starved, .killer = {}}, robots.view(), rng, empty));
}

TEST_CASE("last seen victim: birth in the remembered body -> unchanged, another body closest -> renewed") {
  const LastSeenVictim rule;
  HandPopulation robots{{{.species = predator}, {.species = prey, .x_m = 1.0}, {.species = prey, .x_m = 2.0}}};
  LastSeenVictim::State own;
  const auto look = [&](std::optional<BodyIndex> adversary) {
    const auto sighting = adversary ? std::optional{Sighting{.self = 0, .adversary = *adversary}} : std::nullopt;
    rule.on_sighting(own, 0, sighting, robots.view());
    return own.victim ? std::optional{own.victim->id} : std::nullopt;
  };
  CHECK_FALSE(look(std::nullopt));
  CHECK(look(1) == 1);
  robots.individuals[1].id = 50;
  CHECK(look(1) == 1);
  CHECK(look(2) == 2);
  CHECK(look(1) == 50);
  CHECK(look(std::nullopt) == 50);
  CHECK(rule.born({}, nullptr, own).victim == own.victim);
  rule.on_catch(own, 0, 2, robots.view());
  CHECK_FALSE(own.body);
  CHECK_FALSE(own.victim);
}

TEST_CASE("last seen victim: species that it does not eat -> not remembered") {
  const LastSeenVictim rule;
  const HandPopulation robots{{{.species = grazer}, {.species = hunter, .x_m = 1.0}, {.species = plant, .x_m = 4.0}},
                              chain_web()};
  LastSeenVictim::State own;
  rule.on_sighting(own, 0, Sighting{.self = 0, .adversary = 1}, robots.view());
  CHECK_FALSE(own.body);
  rule.on_sighting(own, 0, Sighting{.self = 0, .adversary = 2}, robots.view());
  CHECK(own.body == 2);
}

TEST_CASE("most escapes: from within 3 m to beyond 5 m -> one escape, whatever the way between") {
  Walks<MostEscapes> walks{1};
  for (const double x_m : {4.0, 6.0, 3.0, 5.0, 4.0, 5.0}) walks.to({x_m});
  CHECK(walks.states()[1].escapes == 0);
  CHECK(walks.parent() == std::nullopt);
  walks.to({5.01});
  CHECK(walks.states()[1].escapes == 1);
  CHECK(walks.parent() == 1);
  walks.to({9.0});
  CHECK(walks.states()[1].escapes == 1);
}

TEST_CASE("most escapes: greatest number of escapes -> parent, of equal numbers the closest") {
  Walks<MostEscapes> walks{2};
  walks.to({2.0, 2.5});
  walks.to({6.0, 7.0});
  CHECK(walks.parent() == 1);
  walks.to({6.0, 1.0});
  walks.to({6.0, 8.0});
  CHECK(walks.parent() == 2);
  walks.robots().individuals[2].active = false;
  CHECK(walks.parent() == 1);
  CHECK(walks.parent(predator) == std::nullopt);
}

TEST_CASE("most escapes: dead pursuer or inactive newborn -> no escape") {
  Walks<MostEscapes> walks{2};
  walks.robots().individuals[2].active = false;
  walks.to({2.0, 2.0});
  walks.robots().individuals[0].id = 77;
  walks.robots().individuals[2].active = true;
  walks.to({9.0, 9.0});
  CHECK(walks.states()[1].escapes == 0);
  CHECK(walks.states()[1].pursuers.empty());
  CHECK(walks.states()[2].escapes == 0);
}

namespace {

template <class Rule>
std::optional<IndividualId> parent_by(const Rule& rule, BodyIndex body, const HandPopulation& robots) {
  Rng rng{1, Stream::parent};
  const auto parent = rule.parent({.body = body, .cause = Cause::starved, .killer = {}}, robots.view(), rng);
  return parent ? std::optional{parent->id} : std::nullopt;
}

}  // namespace

TEST_CASE("nearest victim: any tags and activity -> closest prey, nearest active victim -> closest active prey") {
  const HandPopulation robots{{{.species = predator},
                               {.species = prey, .x_m = 3.0, .tag = 1},
                               {.species = prey, .y_m = -2.0, .tag = -1, .active = false},
                               {.species = predator, .x_m = 0.5}}};
  CHECK(parent_by(NearestActiveVictim{}, 0, robots) == 1);
  CHECK(parent_by(NearestVictim{}, 0, robots) == 2);
}

TEST_CASE("nearest active victim: only inactive prey -> none") {
  CHECK(parent_by(NearestActiveVictim{}, 0, HandPopulation{{{.species = predator}, {.species = prey, .active = false}}}) ==
        std::nullopt);
}

TEST_CASE("nearest active victim: distance equal to the range -> within it") {
  HandPopulation robots{{{.species = predator}, {.species = prey, .x_m = 12.0}}};
  CHECK(parent_by(NearestActiveVictim{}, 0, robots) == 1);
  robots.poses[1].x_m = 12.0000001;
  CHECK(parent_by(NearestActiveVictim{}, 0, robots) == std::nullopt);
  CHECK(parent_by(NearestActiveVictim{{.range_m = 13.0}}, 0, robots) == 1);
}

TEST_CASE("nearest active victim: all active -> as nearest victim, in any order of bodies") {
  CHECK(rc::check([](std::uint64_t seed) {
    HandPopulation robots = random_population(seed, 15);
    for (Individual& individual : robots.individuals) individual.active = true;
    const auto order = random_order(seed, 15);
    const HandPopulation moved = robots.reordered(order);
    for (BodyIndex body = 0; body < 15; ++body) {
      const auto parent = parent_by(NearestActiveVictim{{.range_m = 4.0}}, order[body], robots);
      RC_ASSERT(parent == parent_by(NearestVictim{{.range_m = 4.0}}, order[body], robots));
      RC_ASSERT(parent == parent_by(NearestActiveVictim{{.range_m = 4.0}}, body, moved));
    }
  }));
}

TEST_CASE("nearest conspecific: any tags and activity -> closest of the species, alone -> none") {
  const reproduction::parent::NearestConspecific rule;
  Rng rng{1, Stream::parent};
  const HandPopulation robots{{{.species = prey},
                               {.species = predator, .x_m = 0.5},
                               {.species = prey, .x_m = 8.0},
                               {.species = prey, .x_m = 7.0, .tag = -1, .active = false, .id = 70}}};
  const auto parent = rule.parent({.body = 0, .cause = Cause::senescence, .successor = prey}, robots.view(), rng);
  REQUIRE(parent);
  CHECK(parent->id == 70);
  CHECK(parent->species == prey);
  CHECK_FALSE(rule.parent({.body = 1, .cause = Cause::senescence, .successor = predator}, robots.view(), rng));
}

TEST_CASE("nearest victim: distance equal to the range -> within it") {
  HandPopulation robots{{{.species = predator}, {.species = prey, .x_m = 4.0}}};
  CHECK(parent_by(NearestVictim{}, 0, robots) == 1);
  robots.poses[1].x_m = 4.0000001;
  CHECK(parent_by(NearestVictim{}, 0, robots) == std::nullopt);
  CHECK(parent_by(NearestVictim{{.range_m = 5.0}}, 0, robots) == 1);
}

TEST_CASE("nearest victim: equal distance -> lower body, no prey -> none") {
  CHECK(parent_by(NearestVictim{}, 1,
                  HandPopulation{{{.species = prey, .x_m = -1.0}, {.species = predator}, {.species = prey, .x_m = 1.0}}}) == 0);
  CHECK(parent_by(NearestVictim{}, 0, HandPopulation{{{.species = predator}, {.species = predator, .x_m = 1.0}}}) ==
        std::nullopt);
}

TEST_CASE("nearest victim: food chain -> only species that the dead individual ate") {
  const HandPopulation robots{{{.species = plant, .x_m = 2.0}, {.species = grazer, .x_m = 1.0}, {.species = hunter}},
                              chain_web()};
  CHECK(parent_by(NearestVictim{}, 2, robots) == 1);
  CHECK(parent_by(NearestVictim{}, 1, robots) == 0);
  CHECK(parent_by(NearestVictim{}, 0, robots) == std::nullopt);
}

TEST_CASE("nearest victim: random populations -> closest prey, any order of bodies") {
  CHECK(rc::check([](std::uint64_t seed) {
    const HandPopulation robots = random_population(seed, 15);
    const auto order = random_order(seed, 15);
    const HandPopulation moved = robots.reordered(order);
    for (BodyIndex body = 0; body < 15; ++body) {
      const auto parent = parent_by(NearestVictim{}, order[body], robots);
      RC_ASSERT(parent == parent_by(NearestVictim{}, body, moved));
      bool any_in_range = false;
      for (BodyIndex other = 0; other < 15; ++other) {
        const bool eaten = robots.web.eats(robots.individuals[order[body]].species, robots.individuals[other].species);
        any_in_range = any_in_range || (eaten && robots.view().distance_m(order[body], other) <= 4.0);
      }
      RC_ASSERT(parent.has_value() == any_in_range);
    }
  }));
}

TEST_CASE("no parent: prey and a killer present -> none") {
  const HandPopulation robots{{{.species = prey}, {.species = predator, .x_m = 0.5}}};
  Rng rng{1, Stream::parent};
  CHECK_FALSE(reproduction::parent::NoParent{}.parent({.body = 0, .cause = Cause::caught, .killer = 1}, robots.view(), rng));
}
