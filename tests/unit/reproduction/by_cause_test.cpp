// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/hand_population.hpp>
#include <trophic/params/named_params.hpp>
#include <trophic/reproduction/parent/by_cause.hpp>
#include <trophic/reproduction/parent/killer.hpp>
#include <trophic/reproduction/parent/last_killer.hpp>
#include <trophic/reproduction/parent/nearest_conspecific.hpp>
#include <trophic/reproduction/parent/nearest_victim.hpp>

using namespace trophic;
using namespace trophic::test;
using namespace reproduction::parent;
using Four = ByCause<Killer, NearestVictim, LastKiller, NearestConspecific>;

static_assert(reproduction::Parent<Four>);

TEST_CASE("by cause: cause of death -> its own rule") {
  const HandPopulation robots{{{.species = predator}, {.species = prey, .x_m = 1.0}, {.species = predator, .x_m = 3.0}}};
  const std::vector<LastKiller::State> killers{{.killer = ancestor(77, predator)}, {}, {}};
  Four::States states;
  std::get<2>(states) = killers;
  const auto parent = [&](Cause cause) {
    Rng rng{1, Stream::parent};
    const auto found = Four{}.parent({.body = 0, .cause = cause, .killer = 2}, robots.view(), rng, states);
    return found ? std::optional{found->id} : std::nullopt;
  };
  CHECK(parent(Cause::caught) == 2);
  CHECK(parent(Cause::starved) == 1);
  CHECK(parent(Cause::sacrificed) == 77);
  CHECK(parent(Cause::senescence) == 2);
}

TEST_CASE("by cause: cause without a rule -> no parent, not in the name") {
  using Two = ByCause<Killer, NearestVictim>;
  const HandPopulation robots{{{.species = predator}, {.species = prey, .x_m = 1.0}}};
  Rng rng{1, Stream::parent};
  for (const Cause cause : {Cause::sacrificed, Cause::senescence}) {
    CHECK_FALSE(Two{}.parent({.body = 0, .cause = cause, .killer = 1}, robots.view(), rng, {}));
  }
  CHECK(Two::name == "caught: killer, starved: nearest_victim");
  CHECK(Four::name == "caught: killer, starved: nearest_victim, sacrificed: last_killer, senescence: nearest_conspecific");
}

TEST_CASE("by cause: numbers -> under the name of their cause") {
  std::vector<std::string> paths;
  for (const NamedParam& param : named_params_of(Four::Params{})) paths.push_back(param.path);
  CHECK(paths == std::vector<std::string>{"starved.range_m"});
  const HandPopulation robots{{{.species = predator}, {.species = prey, .x_m = 4.5}}};
  Rng rng{1, Stream::parent};
  CHECK_FALSE(Four{}.parent({.body = 0, .cause = Cause::starved}, robots.view(), rng, {}));
  CHECK(Four{{.starved = {.range_m = 5.0}}}.parent({.body = 0, .cause = Cause::starved}, robots.view(), rng, {}));
}
