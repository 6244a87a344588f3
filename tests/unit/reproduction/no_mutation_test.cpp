// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <trophic/reproduction/mutation/no_mutation.hpp>
#include <vector>

using namespace trophic;

TEST_CASE("no mutation: any genome -> weights unchanged, no draws") {
  std::vector<double> weights{0.5, -1.0, 7.0};
  Rng rng{1, Stream::mutation};
  Rng reference = rng;
  reproduction::mutation::NoMutation{}.mutate(weights, Individual{}, rng);
  CHECK(weights == std::vector<double>{0.5, -1.0, 7.0});
  CHECK(rng.bits() == reference.bits());
}
