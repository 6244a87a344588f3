// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <memory>
#include <trophic/reproduction/heredity/shared_copy.hpp>

using namespace trophic;

TEST_CASE("shared copy: parent, offspring and grandchild -> one object, each mutation reaches all") {
  const auto parent = std::make_shared<Genome>(Genome{.id = 3, .weights = {0.25, -0.5}});
  const reproduction::heredity::SharedCopy rule;
  const auto offspring = rule.inherit(parent);
  const auto grandchild = rule.inherit(offspring);
  grandchild->weights[1] = 1.0;
  CHECK(parent->weights[1] == 1.0);
  CHECK(offspring->weights[1] == 1.0);
  CHECK(grandchild->id == 3);
}
