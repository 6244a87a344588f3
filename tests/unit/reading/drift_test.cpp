// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <set>
#include <tools/reading/drift.hpp>
#include <unit/reading/forests.hpp>

using namespace trophic;
using namespace trophic::analysis;
using doctest::Approx;
using trophic::test::alive;
using trophic::test::one;

TEST_CASE("drift: 4000 draws -> parents evenly among the living of the species, roots' genomes and mutations permuted") {
  // 0 and 1 may be the parent of 5; 2 has died at its birth, 3 is of another species, 4 is born with it. 7 is a later root.
  const Forest forest{one({}, 0.0, alive, 0.0),     one({}, 0.0, alive, 10.0), one({}, 0.0, 5.0, 20.0),
                      one({}, 0.0, alive, 30.0, 1), one({}, 5.0, alive, 40.0), one(0, 5.0, alive, 0.5),
                      one(5, 6.0, alive, 0.25),     one({}, 7.0, alive, 50.0)};
  int first = 0;
  int own_mutation = 0;
  int own_genome = 0;
  for (std::uint64_t seed = 0; seed < 4000; ++seed) {
    Rng rng{seed, Stream::user};
    const Forest drifted = drift_of(forest, rng);
    REQUIRE(drifted[5].parent);
    const std::size_t parent = *drifted[5].parent;
    REQUIRE((parent == 0 || parent == 1));
    first += parent == 0 ? 1 : 0;
    const double mutation = drifted[5].weights[0] - drifted[parent].weights[0];
    CHECK((mutation == Approx(0.5) || mutation == Approx(-0.25)));
    own_mutation += mutation > 0.0 ? 1 : 0;
    CHECK(drifted[6].weights[0] - drifted[*drifted[6].parent].weights[0] == Approx(0.25 - mutation));
    const double founders = drifted[0].weights[0] + 2.0 * drifted[1].weights[0] + 4.0 * drifted[2].weights[0];
    CHECK(drifted[0].weights[0] + drifted[1].weights[0] + drifted[2].weights[0] == 30.0);
    own_genome += founders == 100.0 ? 1 : 0;
    CHECK(drifted[3].weights == forest[3].weights);
    CHECK(drifted[4].weights[0] + drifted[7].weights[0] == 90.0);
    CHECK_FALSE(drifted[4].parent);
    CHECK(drifted[5].death_s == forest[5].death_s);
  }
  CHECK(first / 4000.0 == Approx(0.5).epsilon(0.05));
  CHECK(own_mutation / 4000.0 == Approx(0.5).epsilon(0.05));
  CHECK(own_genome / 4000.0 == Approx(1.0 / 6.0).epsilon(0.15));
}

TEST_CASE("drift: no other member alive -> parent and genomes are kept") {
  const Forest forest{one({}, 0.0, 5.0, 1.0), one(0, 5.0, alive, 1.5)};
  Rng rng{1, Stream::user};
  const Forest drifted = drift_of(forest, rng);
  CHECK(*drifted[1].parent == 0);
  CHECK(drifted[1].weights == forest[1].weights);
}

TEST_CASE("drift: two parents -> two others, the mean of their weights and a crossover of the run") {
  Forest forest{one({}, 0.0, alive, 1.0), one({}, 0.0, alive, 3.0), one({}, 0.0, alive, 9.0), one(0, 5.0, alive, 2.5)};
  forest[3].others = {1};
  std::set<std::size_t> parents;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Rng rng{seed, Stream::user};
    const Forest drifted = drift_of(forest, rng);
    const Taxon& child = drifted[3];
    REQUIRE(child.others.size() == 1);
    CHECK(*child.parent != child.others[0]);
    parents.insert({*child.parent, child.others[0]});
    CHECK(child.weights[0] == Approx(0.5 + (drifted[*child.parent].weights[0] + drifted[child.others[0]].weights[0]) / 2.0));
  }
  CHECK(parents == std::set<std::size_t>{0, 1, 2});
}
