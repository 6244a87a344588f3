// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cstdint>
#include <trophic/reproduction/genome_source/always_inherited.hpp>

using namespace trophic;

TEST_CASE("always inherited: any controller -> of a parent, no draws, without a parent -> random") {
  const reproduction::genome_source::AlwaysInherited rule;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Rng rng{seed, Stream::genome_source};
    Rng reference = rng;
    CHECK(rule.descent(rng) == reproduction::Descent::of_parent);
    CHECK(rng.bits() == reference.bits());
  }
}
