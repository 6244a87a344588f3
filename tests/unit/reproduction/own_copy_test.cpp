// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <memory>
#include <trophic/reproduction/heredity/own_copy.hpp>
#include <vector>

using namespace trophic;

TEST_CASE("own copy: parent -> equal weights in another object, parent unchanged by mutation") {
  const auto parent = std::make_shared<Genome>(Genome{.id = 3, .weights = {0.25, -0.5}});
  const auto offspring = reproduction::heredity::OwnCopy{}.inherit(parent);
  REQUIRE(offspring != parent);
  CHECK(offspring->weights == parent->weights);
  offspring->weights[0] = 9.0;
  CHECK(parent->weights == std::vector<double>{0.25, -0.5});
}
