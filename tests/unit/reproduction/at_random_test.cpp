// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <array>
#include <cstdint>
#include <map>
#include <support/hand_population.hpp>
#include <trophic/reproduction/parent/at_random.hpp>
#include <trophic/reproduction/parent/killer.hpp>
#include <trophic/reproduction/parent/last_killer.hpp>
#include <trophic/reproduction/parent/nearest_conspecific.hpp>
#include <trophic/reproduction/parent/no_parent.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::test;
using namespace trophic::reproduction::parent;

namespace {

const HandPopulation crowd{{{.species = prey, .id = 10},
                            {.species = predator, .id = 20},
                            {.species = predator, .x_m = 3.0, .id = 30},
                            {.species = prey, .id = 40},
                            {.species = predator, .x_m = 9.0, .active = false, .id = 50}}};

}  // namespace

TEST_CASE("at random: the killer -> every living hunter equally often, no prey") {
  std::map<IndividualId, int> chosen;
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    Rng rng{seed, Stream::parent};
    const auto parent = AtRandom<Killer>{}.parent({.body = 0, .cause = Cause::caught, .killer = 1}, crowd.view(), rng);
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

TEST_CASE("at random: the dying individual -> never its own successor's parent") {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Rng rng{seed, Stream::parent};
    const Vacancy death{.body = 0, .cause = Cause::senescence, .successor = prey};
    CHECK(AtRandom<NearestConspecific>{}.parent(death, crowd.view(), rng)->id == 40);
  }
}

TEST_CASE("at random: a rule that names no parent -> none, without a draw") {
  Rng rng{1, Stream::parent};
  CHECK_FALSE(AtRandom<NoParent>{}.parent({.body = 0}, crowd.view(), rng));
  CHECK(rng.bits() == Rng{1, Stream::parent}.bits());
}

TEST_CASE("at random: a rule with a state whose parent is dead, none of its species lives -> that parent") {
  const HandPopulation all_prey{{{.species = prey, .id = 10}, {.species = prey, .id = 40}}};
  std::vector<LastKiller::State> states(2);
  states[0].killer = ancestor(7, predator);
  Rng rng{1, Stream::parent};
  const Vacancy death{.body = 0, .cause = Cause::sacrificed, .successor = predator};
  CHECK(AtRandom<LastKiller>{}.parent(death, all_prey.view(), rng, states)->id == 7);
  CHECK(AtRandom<LastKiller>::name == "at_random_last_killer");
}
