// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <trophic/reproduction/genome_source/random_or_inherited.hpp>

using namespace trophic;
using reproduction::Descent;
using reproduction::genome_source::RandomOrInherited;

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
