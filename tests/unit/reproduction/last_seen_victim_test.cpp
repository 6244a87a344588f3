// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <optional>
#include <support/hand_population.hpp>
#include <trophic/reproduction/parent/last_seen_victim.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::test;
using reproduction::parent::LastSeenVictim;

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
