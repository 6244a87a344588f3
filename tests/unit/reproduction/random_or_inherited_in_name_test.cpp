// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cstdint>
#include <trophic/reproduction/genome_source/random_or_inherited.hpp>
#include <trophic/reproduction/genome_source/random_or_inherited_in_name.hpp>

using namespace trophic;
using reproduction::Descent;
using reproduction::genome_source::RandomOrInherited;
using reproduction::genome_source::RandomOrInheritedInName;

TEST_CASE("random or inherited in name: no parent -> labelled inherited") {
  Rng rng{1, Stream::genome_source};
  CHECK(RandomOrInheritedInName{{.random_share = 0.0}}.descent(rng) == Descent::of_parent_in_name);
}

TEST_CASE("random or inherited in name: draws -> those of random or inherited") {
  for (const double random_share : {0.0, 1.0 / 3.0, 0.34, 1.0}) {
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
      Rng rng{seed, Stream::genome_source};
      Rng reference = rng;
      const Descent descent = RandomOrInheritedInName{{.random_share = random_share}}.descent(rng);
      const Descent other = RandomOrInherited{{.random_share = random_share}}.descent(reference);
      CHECK((descent == Descent::random) == (other == Descent::random));
      CHECK(rng.bits() == reference.bits());
    }
  }
}
