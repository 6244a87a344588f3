// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <memory>
#include <trophic/reproduction/heredity/nothing_inherited.hpp>

using namespace trophic;

TEST_CASE("nothing inherited: any parent -> no genome passed on") {
  const auto parent = std::make_shared<Genome>(Genome{.id = 3, .weights = {0.5}});
  CHECK(reproduction::heredity::NothingInherited{}.inherit(parent) == nullptr);
}
