// SPDX-License-Identifier: MIT
// The policies of this slot, each by its name.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <trophic/reproduction/genome_source/always_inherited.hpp>
#include <trophic/reproduction/genome_source/random_or_inherited.hpp>
#include <trophic/reproduction/genome_source/random_or_inherited_in_name.hpp>

using namespace trophic;
using reproduction::Descent;
using reproduction::genome_source::RandomOrInherited;
using reproduction::genome_source::RandomOrInheritedInName;

TEST_CASE("always inherited: any controller -> of a parent, no draws, without a parent -> random") {
  const reproduction::genome_source::AlwaysInherited rule;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Rng rng{seed, Stream::genome_source};
    Rng reference = rng;
    CHECK(rule.descent(rng) == reproduction::Descent::of_parent);
    CHECK(rng.bits() == reference.bits());
  }
}

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

TEST_CASE("random or inherited: many draws -> 1/3 random and 2/3 inherited, or as set") {
  constexpr int size = 200'000;
  for (const double random_share : {1.0 / 3.0, 0.34, 0.0, 1.0}) {
    const RandomOrInherited rule{{.random_share = random_share}};
    int random = 0;
    for (int i = 0; i < size; ++i) {
      Rng rng{16, Stream::genome_source, static_cast<std::uint64_t>(i)};
      if (rule.descent(rng) == Descent::random) ++random;
    }
    const double standard_error = std::sqrt(random_share * (1.0 - random_share) / size);
    CHECK(std::abs(static_cast<double>(random) / size - random_share) <= 4.0 * standard_error);
  }
  CHECK(RandomOrInherited{}.params.random_share == 1.0 / 3.0);
}

TEST_CASE("random or inherited: no parent -> labelled random") {
  Rng rng{1, Stream::genome_source};
  CHECK(RandomOrInherited{{.random_share = 0.0}}.descent(rng) == Descent::of_parent);
}

TEST_CASE("random or inherited: one controller -> one draw") {
  Rng rng{1, Stream::genome_source};
  Rng reference = rng;
  const Descent descent = RandomOrInherited{}.descent(rng);
  CHECK(descent == (reference.uniform() >= 1.0 / 3.0 ? Descent::of_parent : Descent::random));
  CHECK(rng.bits() == reference.bits());
}
